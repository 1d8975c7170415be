#include "core/rng.hpp"

#include <Random123/philox.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/check.hpp"
#include "tests/support/kolmogorov_smirnov.hpp"
#include "tests/support/statistics.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;

// Random123, tests/kat_vectors, lines "philox4x32 10".
TEST(Rng, PhiloxMeetsThePublishedVectors) {
  const r123::Philox4x32 philox;
  EXPECT_THAT(philox({{0, 0, 0, 0}}, {{0, 0}}), ElementsAre(0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U));
  EXPECT_THAT(philox({{0xffffffffU, 0xffffffffU, 0xffffffffU, 0xffffffffU}}, {{0xffffffffU, 0xffffffffU}}),
              ElementsAre(0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU));
  EXPECT_THAT(philox({{0x243f6a88U, 0x85a308d3U, 0x13198a2eU, 0x03707344U}}, {{0xa4093822U, 0x299f31d0U}}),
              ElementsAre(0xd16cfe09U, 0x94fdccebU, 0x5001e420U, 0x24126ea1U));
}

TEST(Rng, StreamOfZerosBeginsWithThePublishedVector) {
  Rng rng({.seed = 0, .purpose = Purpose{0}, .entity = 0, .tick = 0});
  EXPECT_EQ(rng.bits(), 0x6627e8d5U);
  EXPECT_EQ(rng.bits(), 0xe169c58dU);
  EXPECT_EQ(rng.bits64(), 0xbc57ac4c9b00dbd8U);
}

TEST(Rng, StreamIsThePhiloxOfItsNameBlockByBlock) {
  const StreamKey key{.seed = 0xa4093822U, .purpose = Purpose::kResample, .entity = 77, .tick = 0x123456789abcULL};
  Rng rng(key);
  for (std::uint32_t block = 0; block < 3; ++block) {
    const auto expected = r123::Philox4x32{}({{block, 77, 0x56789abcU, 0x1234U}}, {{0xa4093822U, 10}});
    for (const std::uint32_t word : expected) EXPECT_EQ(rng.bits(), word);
  }
}

TEST(Rng, DrawsDoNotDependOnTheOrderOfStreams) {
  std::vector<std::vector<double>> forwards(50), backwards(50);
  const auto draw = [](std::uint32_t entity) {
    Rng rng({.seed = 7, .purpose = Purpose::kMotionSample, .entity = entity, .tick = 3});
    return std::vector<double>{rng.normal(), rng.uniform(), rng.normal(), static_cast<double>(rng.below(9))};
  };
  for (std::uint32_t e = 0; e < 50; ++e) forwards[e] = draw(e);
  for (std::uint32_t e = 50; e-- > 0;) backwards[e] = draw(e);
  EXPECT_EQ(forwards, backwards);
}

TEST(Rng, KeysThatDifferInOneFieldGiveDifferentStreams) {
  const StreamKey base{.seed = 1, .purpose = Purpose::kLidarNoise, .entity = 1, .tick = 1};
  std::vector<StreamKey> keys(6, base);
  keys[1].seed = 2;
  keys[2].purpose = Purpose::kCompassNoise;
  keys[3].entity = 2;
  keys[4].tick = 2;
  keys[5].tick = 1 + (std::uint64_t{1} << 32);
  std::set<std::uint64_t> first;
  for (const StreamKey& key : keys) first.insert(Rng(key).bits64());
  EXPECT_EQ(first.size(), keys.size());
}

TEST(Rng, RejectsATickThatWouldMeetTheBlockCounter) {
  EXPECT_THROW(Rng({.tick = std::uint64_t{1} << 48}), ContractViolation);
}

TEST(Rng, UniformIsUniform) {
  Rng rng({.seed = 8, .purpose = Purpose::kWorld});
  std::vector<double> draws(100'000);
  for (double& d : draws) d = rng.uniform();
  // Four standard errors: 4 sqrt(1/12 / n), and 4 sqrt(1/180 / n) of the variance.
  EXPECT_NEAR(moments(draws).mean, 0.5, 0.0037);
  EXPECT_NEAR(moments(draws).variance, 1.0 / 12.0, 0.00095);
  EXPECT_LT(ks_statistic(draws, [](double x) { return x; }), 1.63);
}

TEST(Rng, NormalIsNormal) {
  Rng rng({.seed = 9, .purpose = Purpose::kWorld});
  std::vector<double> draws(1'000'000), products;
  for (double& d : draws) d = rng.normal();
  for (std::size_t i = 0; i + 1 < draws.size(); i += 2) products.push_back(draws[i] * draws[i + 1]);
  EXPECT_NEAR(moments(draws).mean, 0.0, 4.0 / std::sqrt(1e6));
  EXPECT_NEAR(moments(draws).variance, 1.0, 4.0 * std::sqrt(2.0 / 1e6));
  EXPECT_LT(ks_statistic(draws, [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }), 1.63);
  EXPECT_NEAR(moments(products).mean, 0.0, 4.0 / std::sqrt(5e5));  // the two halves of a Box-Muller pair
}

TEST(Rng, BelowIsUnbiased) {
  // With 3 * 2^30 a plain remainder would draw the lowest third twice as often as the rest.
  constexpr std::uint32_t kBound = 3U << 30;
  constexpr int kDraws = 90'000;
  Rng rng({.seed = 10, .purpose = Purpose::kWorld});
  int third[3] = {0, 0, 0};
  for (int i = 0; i < kDraws; ++i) {
    const std::uint32_t draw = rng.below(kBound);
    ASSERT_LT(draw, kBound);
    ++third[draw >> 30];
  }
  for (const int count : third) EXPECT_NEAR(count, kDraws / 3, 4.0 * std::sqrt(kDraws * 2.0 / 9.0));
}

TEST(Rng, BelowReachesEveryValueOfASmallBound) {
  Rng rng({.seed = 11, .purpose = Purpose::kWorld});
  std::set<std::uint32_t> seen;
  for (int i = 0; i < 200; ++i) seen.insert(rng.below(7));
  EXPECT_THAT(seen, ElementsAre(0, 1, 2, 3, 4, 5, 6));
  EXPECT_EQ(rng.below(1), 0U);
  EXPECT_THROW(rng.below(0), ContractViolation);
}

}  // namespace
}  // namespace cogslam
