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

TEST(Stats, TellsTheMiddle) {
  const double odd[] = {5.0, 1.0, 3.0}, even[] = {4.0, 1.0, 3.0, 2.0};
  EXPECT_EQ(median(odd), 3.0);
  EXPECT_EQ(median(even), 2.5);
  EXPECT_EQ(mean_interval(std::vector<double>{7.0}).half_width, 0.0);
}

}  // namespace
}  // namespace cogslam
