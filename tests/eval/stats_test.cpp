#include "eval/stats.hpp"

#include <gtest/gtest.h>

#include "core/rng.hpp"

namespace cogslam {
namespace {

TEST(Stats, KnowsStudentsT) {
  EXPECT_NEAR(student_t_975(1), 12.7062, 1e-4);
  EXPECT_NEAR(student_t_975(10), 2.228139, 1e-6);
  EXPECT_NEAR(student_t_975(11), 2.200985, 5e-5);
  EXPECT_NEAR(student_t_975(29), 2.045230, 5e-6);
  EXPECT_NEAR(student_t_975(1000), 1.962339, 1e-6);
}

TEST(Stats, CoversTheTrueMeanNineteenTimesOutOfTwenty) {
  int covered = 0;
  const int draws = 4000;
  for (int i = 0; i < draws; ++i) {
    Rng rng({.seed = static_cast<std::uint32_t>(i)});
    double values[5];
    for (double& v : values) v = 3.0 + 2.0 * rng.normal();
    const MeanInterval interval = mean_interval(values);
    covered += interval.low() <= 3.0 && 3.0 <= interval.high() ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(covered) / draws, 0.95, 0.012);
}

TEST(Stats, BootstrapsTheMeanAsTheCentralLimitSays) {
  int covered = 0;
  const int draws = 1000;
  for (int i = 0; i < draws; ++i) {
    Rng rng({.seed = static_cast<std::uint32_t>(i)});
    double values[30];
    for (double& v : values) v = 3.0 + 2.0 * rng.normal();
    const Interval interval = bootstrap_mean(values, 1, 500);
    covered += interval.low <= 3.0 && 3.0 <= interval.high ? 1 : 0;
  }
  // Of 30 normal values the percentile interval covers about 0.937 (it uses z and n where t has n - 1).
  EXPECT_NEAR(static_cast<double>(covered) / draws, 0.937, 0.025);
}

TEST(Stats, ComparesPairsWithoutTheSpreadThatTheyShare) {
  double values[20], references[20];
  for (std::uint32_t i = 0; i < 20; ++i) {
    Rng rng({.seed = 7, .entity = i});
    references[i] = 10.0 * rng.normal();
    values[i] = references[i] + 0.5 + 0.1 * rng.normal();
  }
  const PairedComparison pairs = compare_pairs(values, references);
  EXPECT_EQ(pairs.difference.count, 20U);
  EXPECT_NEAR(pairs.difference.mean, 0.5, 0.1);
  EXPECT_LT(pairs.difference.half_width, 0.1) << "alone, each mean is known to within 5";
  EXPECT_LT(pairs.bootstrap.low, pairs.difference.mean);
  EXPECT_GT(pairs.bootstrap.high, pairs.difference.mean);
  EXPECT_NEAR(pairs.bootstrap.high - pairs.bootstrap.low, 2.0 * pairs.difference.half_width,
              0.5 * pairs.difference.half_width);
  EXPECT_GT(pairs.correlation.value(), 0.999);
}

TEST(Stats, KnowsNoCorrelationOfWhatDoesNotVary) {
  const double same[] = {0.1, 0.1, 0.1}, other[] = {1.0, 2.0, 3.0}, falling[] = {3.0, 2.0, 1.0};
  EXPECT_EQ(compare_pairs(same, other).correlation, std::nullopt);
  EXPECT_NEAR(compare_pairs(falling, other).correlation.value(), -1.0, 1e-12);
}

TEST(Stats, TellsTheMiddle) {
  const double odd[] = {5.0, 1.0, 3.0}, even[] = {4.0, 1.0, 3.0, 2.0};
  EXPECT_EQ(median(odd), 3.0);
  EXPECT_EQ(median(even), 2.5);
  EXPECT_EQ(mean_interval(std::vector<double>{7.0}).half_width, 0.0);
}

}  // namespace
}  // namespace cogslam
