#include "slam/codec/top_m.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <vector>

#include "core/check.hpp"
#include "core/rng.hpp"
#include "slam/codec/haar.hpp"
#include "tests/support/slow_top_m.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Rng random_stream(std::uint32_t seed) { return Rng({.seed = seed, .purpose = Purpose::kWorld}); }

CoefficientCode top_m(const std::vector<float>& coefficients, std::size_t m) {
  CoefficientCode code;
  TopMScratch scratch;
  select_top_m(coefficients, m, code, scratch);
  return code;
}

// Like Haar coefficients of a map: many zeros of both signs, many equal magnitudes, a wide range.
std::vector<float> random_coefficients(std::size_t count, Rng& rng) {
  std::vector<float> coefficients(count);
  for (float& c : coefficients) {
    const double sign = rng.uniform() < 0.5 ? -1.0 : 1.0;
    switch (rng.below(3)) {
      case 0:
        c = static_cast<float>(sign * 0.0);
        break;
      case 1:
        c = static_cast<float>(sign * 0.25 * (1 + rng.below(4)));
        break;
      default:
        c = static_cast<float>(sign * std::exp(3.0 * rng.normal()));
    }
  }
  return coefficients;
}

double squares(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) {
    sum += static_cast<double>(value) * static_cast<double>(value);
  }
  return sum;
}

TEST(KeptCount, RoundsHalvesUp) {
  EXPECT_EQ(kept_count(128, 5.0), 6U);    // 6.4
  EXPECT_EQ(kept_count(128, 10.0), 13U);  // 12.8
  EXPECT_EQ(kept_count(1, 50.0), 1U);
  EXPECT_EQ(kept_count(1840, 40.0), 736U);
  EXPECT_EQ(kept_count(1840, 0.0), 0U);
  EXPECT_EQ(kept_count(1840, 100.0), 1840U);
  EXPECT_THROW(kept_count(10, 100.1), ContractViolation);
  EXPECT_THROW(kept_count(10, std::numeric_limits<double>::quiet_NaN()), ContractViolation);
}

TEST(TopM, KeepsTheLargestMagnitudesInIndexOrder) {
  const CoefficientCode code = top_m({1.0F, -5.0F, 0.5F, 3.0F, 0.0F, -2.0F}, 3);
  EXPECT_THAT(code.indices, ElementsAre(1U, 3U, 5U));
  EXPECT_THAT(code.values, ElementsAre(-5.0F, 3.0F, -2.0F));
}

TEST(TopM, KeepsTheLowerIndexOfEqualMagnitudes) {
  EXPECT_THAT(top_m({2.0F, -1.0F, 1.0F, -1.0F, 1.0F, 4.0F}, 4).indices, ElementsAre(0U, 1U, 2U, 5U));
  EXPECT_THAT(top_m(std::vector<float>(9, -1.0F), 2).indices, ElementsAre(0U, 1U));
}

TEST(TopM, NeverKeepsZeros) {
  EXPECT_THAT(top_m({0.0F, 7.0F, -0.0F, 0.0F}, 3).indices, ElementsAre(1U));
  EXPECT_THAT(top_m({0.0F, -0.0F}, 2).indices, IsEmpty());
  EXPECT_THAT(top_m({}, 2).indices, IsEmpty());
  EXPECT_THAT(top_m({1.0F, 2.0F}, 0).indices, IsEmpty());
  EXPECT_THAT(top_m({1.0F, 2.0F}, 5).indices, ElementsAre(0U, 1U));
}

TEST(TopM, EqualsTheStableSort) {
  Rng rng = random_stream(1);
  CoefficientCode code;
  TopMScratch scratch;  // kept between sizes, as a store does
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<float> coefficients = random_coefficients(1 + rng.below(600), rng);
    const std::size_t m = rng.below(static_cast<std::uint32_t>(coefficients.size()) + 10);
    select_top_m(coefficients, m, code, scratch);
    ASSERT_EQ(code, slow::sort_and_keep(coefficients, m)) << "trial " << trial << ", m " << m;
  }
}

TEST(TopM, KeepsTheFirstOfManyEqualMagnitudes) {
  for (const float other : {0.25F, 0.2500001F, 64.0F}) {
    std::vector<float> coefficients(5000);
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      coefficients[i] = (i % 3 == 0 ? -1.0F : 1.0F) * (i % 2 == 0 ? other : 0.25F);
    }
    for (const std::size_t m : {1U, 2499U, 2500U, 2501U, 4999U}) {
      EXPECT_EQ(top_m(coefficients, m), slow::sort_and_keep(coefficients, m)) << other << ", m " << m;
    }
  }
}

TEST(TopM, TellsNeighbouringFloatsApart) {
  Rng rng = random_stream(2);
  std::vector<float> coefficients;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    coefficients.push_back(std::bit_cast<float>(0x3f800000U + rng.below(500)));
  }
  coefficients.push_back(std::numeric_limits<float>::denorm_min());
  coefficients.push_back(std::numeric_limits<float>::max());
  for (const std::size_t m : {1U, 2U, 10U, 500U, 999U, 1001U, 1002U}) {
    EXPECT_EQ(top_m(coefficients, m), slow::sort_and_keep(coefficients, m)) << "m " << m;
  }
}

TEST(TopM, LosesTheSquaresOfTheDroppedAndNeverMoreForLargerM) {
  Rng rng = random_stream(3);
  const HaarCanvas canvas = HaarCanvas::covering(16, 32);
  std::vector<float> map = random_coefficients(canvas.cells(), rng);
  std::vector<float> coefficients(canvas.size());
  std::vector<float> kept(canvas.size());
  std::vector<float> rebuilt(canvas.cells());
  std::vector<float> scratch(canvas.scratch_size());
  haar_forward(canvas, map, coefficients, scratch);
  const double total = squares(coefficients);
  double last_error = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m <= canvas.size(); m += 16) {
    const CoefficientCode code = top_m(coefficients, m);
    reconstruct_fast_l2(code, kept);
    haar_inverse(canvas, kept, rebuilt, scratch);
    for (std::size_t i = 0; i < map.size(); ++i) {
      rebuilt[i] -= map[i];
    }
    const double error = squares(rebuilt);
    EXPECT_NEAR(error, total - squares(code.values), 1e-5 * total) << "m " << m;  // eq. (66), float arithmetic
    EXPECT_LE(error, last_error + 1e-9 * total) << "m " << m;
    last_error = error;
  }
  EXPECT_LT(last_error, 1e-9 * total);
}

TEST(TopM, IsTheBestOfAllSelections) {
  Rng rng = random_stream(4);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<float> coefficients = random_coefficients(8, rng);
    for (std::uint32_t m = 0; m <= 8; ++m) {
      double best = 0.0;
      for (std::uint32_t selection = 0; selection < 256; ++selection) {
        std::vector<float> chosen;
        for (std::uint32_t i = 0; i < 8; ++i) {
          if ((selection >> i & 1U) != 0) {
            chosen.push_back(coefficients[i]);
          }
        }
        best = chosen.size() == m ? std::max(best, squares(chosen)) : best;
      }
      EXPECT_DOUBLE_EQ(squares(top_m(coefficients, m).values), best) << "trial " << trial << ", m " << m;
    }
  }
}

}  // namespace
}  // namespace cogslam
