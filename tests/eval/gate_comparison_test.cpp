#include "eval/gate/gate_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/rng.hpp"

namespace cogslam {
namespace {

/// Figures with logarithms of mean log(level) and this spread.
std::vector<double> figures(std::uint32_t seed, std::uint32_t entity, std::size_t count, double level, double spread) {
  Rng rng({.seed = seed, .entity = entity});
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(level * std::exp(spread * rng.normal()));
  return values;
}

struct Shares {
  double failed = 0.0;
  double not_measured = 0.0;
};

/// Of many gates over 60 baseline and 24 new seeds.
Shares simulated(double change, double spread_now, const ChangeLimits& limits, std::uint32_t gates) {
  Shares shares;
  for (std::uint32_t g = 0; g < gates; ++g) {
    const Change c =
        compare_unpaired(figures(g, 0, 60, 3e-4, 0.14), figures(g, 1, 24, 3e-4 * (1.0 + change), spread_now), limits);
    shares.failed += (c.verdict == Verdict::kFail ? 1.0 : 0.0) / gates;
    shares.not_measured += (c.verdict == Verdict::kNotMeasured ? 1.0 : 0.0) / gates;
  }
  return shares;
}

TEST(GateComparison, FailsAsRarelyAsStatedWhereTheChangeIsTheTolerance) {
  const ChangeLimits limits{.tolerance = 0.02, .effect = 0.25, .false_alarm = 0.01};
  // Three standard errors of a share of 8000 draws: 0.0033. The larger of two errors makes the test a little shy.
  const Shares at = simulated(0.02, 0.14, limits, 8000);
  EXPECT_NEAR(at.failed, 0.01, 0.004);
  EXPECT_LT(simulated(0.0, 0.14, limits, 8000).failed, 0.005) << "unchanged: less often still";
}

TEST(GateComparison, IsNotMadeBoldByAWiderSpread) {
  const ChangeLimits limits{.tolerance = 0.02, .effect = 0.25, .false_alarm = 0.01};
  EXPECT_LT(simulated(0.02, 0.4, limits, 4000).failed, 0.02);
  EXPECT_GT(simulated(0.02, 0.4, limits, 2000).not_measured, 0.9) << "and 25 % cannot be seen through it";
}

TEST(GateComparison, FindsWhatItSaysThatItResolves) {
  const ChangeLimits limits{.tolerance = 0.02, .effect = 0.25, .false_alarm = 0.002, .power = 0.8};
  const double resolves = unpaired_resolution(figures(1, 0, 1000, 3e-4, 0.14), 24, limits);  // about that of 60
  EXPECT_LT(resolves, 0.2);
  double sum = 0.0;
  for (std::uint32_t g = 0; g < 500; ++g) sum += unpaired_resolution(figures(g, 0, 60, 3e-4, 0.14), 24, limits) / 500;
  const Shares shares = simulated(sum, 0.14, limits, 2000);
  EXPECT_NEAR(shares.failed, 0.8, 0.05) << "of changes of " << sum;
  EXPECT_GT(simulated(0.25, 0.14, limits, 2000).failed, 0.9);
}

TEST(GateComparison, PairsTakeAwayWhatSeedsHaveInCommon) {
  const ChangeLimits limits{.tolerance = 0.0, .effect = 0.05, .false_alarm = 0.001};
  const std::vector<double> before = figures(3, 0, 20, 0.01, 0.5);
  std::vector<double> after;
  Rng rng({.seed = 3, .entity = 7});
  for (const double v : before) after.push_back(1.05 * v * std::exp(0.01 * rng.normal()));
  const Change paired = compare_paired(before, after, limits);
  EXPECT_EQ(paired.verdict, Verdict::kFail);
  EXPECT_NEAR(paired.change, 0.05, 0.01);
  EXPECT_LT(paired.resolves, 0.015);
  const Change unpaired = compare_unpaired(before, after, limits);
  EXPECT_EQ(unpaired.verdict, Verdict::kNotMeasured);
  EXPECT_NEAR(unpaired.change, paired.change, 1e-12);
}

TEST(GateComparison, FailsAsRarelyAsStatedInPairs) {
  const ChangeLimits limits{.tolerance = 0.02, .effect = 0.25, .false_alarm = 0.01};
  double failed = 0.0;
  for (std::uint32_t g = 0; g < 8000; ++g) {
    const std::vector<double> before = figures(g, 0, 24, 3e-4, 0.14), noise = figures(g, 1, 24, 1.02, 0.13);
    std::vector<double> after;
    for (std::size_t i = 0; i < before.size(); ++i) after.push_back(before[i] * noise[i]);
    failed += (compare_paired(before, after, limits).verdict == Verdict::kFail ? 1.0 : 0.0) / 8000.0;
  }
  EXPECT_NEAR(failed, 0.01, 0.0033);
}

TEST(GateComparison, IsCertainOfExactFigures) {
  const std::vector<double> bytes(10, 7216.0), same(5, 7216.0), more(5, 7216.0 * 1.02);
  const ChangeLimits limits{.tolerance = 0.01, .effect = 0.05, .false_alarm = 1e-4};
  const Change none = compare_unpaired(bytes, same, limits);
  EXPECT_EQ(none.verdict, Verdict::kPass);
  EXPECT_EQ(none.change, 0.0);
  EXPECT_FALSE(none.better);
  EXPECT_NEAR(none.resolves, 0.01, 1e-12) << "whatever exceeds the tolerance";
  EXPECT_EQ(compare_unpaired(bytes, more, limits).verdict, Verdict::kFail);
  EXPECT_EQ(compare_unpaired(bytes, more, {.tolerance = 0.03, .effect = 0.05}).verdict, Verdict::kPass);
  const Change less = compare_unpaired(more, same, limits);
  EXPECT_EQ(less.verdict, Verdict::kPass);
  EXPECT_TRUE(less.better);
  EXPECT_EQ(compare_paired(same, same, limits).verdict, Verdict::kPass);
  EXPECT_EQ(compare_paired(same, more, limits).p_value, 0.0);
}

TEST(GateComparison, DoesNotLetPassWhatItCannotSee) {
  const ChangeLimits limits{.tolerance = 0.02, .effect = 0.25, .false_alarm = 0.002};
  EXPECT_EQ(compare_unpaired(figures(1, 0, 60, 1.0, 0.14), figures(1, 1, 6, 1.0, 0.14), limits).verdict,
            Verdict::kNotMeasured);
  EXPECT_EQ(compare_unpaired(figures(1, 0, 60, 1.0, 0.14), figures(1, 1, 6, 2.0, 0.14), limits).verdict, Verdict::kFail)
      << "a doubling shows with few seeds as well";
}

}  // namespace
}  // namespace cogslam
