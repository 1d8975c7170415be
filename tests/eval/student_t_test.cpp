#include "eval/student_t.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/stats.hpp"

namespace cogslam {
namespace {

TEST(StudentT, HasTheTailsOfTables) {
  // One and two degrees have closed forms; the others are of scipy.stats.t.sf.
  for (const double t : {0.0, 0.3, 2.0, 50.0}) {
    EXPECT_NEAR(student_t_tail(t, 1.0), std::atan2(1.0, t) / M_PI, 1e-13);
    EXPECT_NEAR(student_t_tail(t, 2.0), 1.0 / (2.0 + t * t + t * std::sqrt(2.0 + t * t)), 1e-13);
  }
  EXPECT_NEAR(student_t_tail(2.228138852, 10.0), 0.025, 1e-10);
  EXPECT_NEAR(student_t_tail(3.0902323, 1e9), 0.001, 1e-9);
}

TEST(StudentT, HasTwoEqualTails) {
  for (const double freedom : {1.0, 3.5, 22.0, 400.0}) {
    for (const double t : {0.1, 1.0, 4.0}) {
      EXPECT_NEAR(student_t_tail(t, freedom) + student_t_tail(-t, freedom), 1.0, 1e-14);
    }
    EXPECT_EQ(student_t_tail(0.0, freedom), 0.5);
    EXPECT_EQ(student_t_tail(HUGE_VAL, freedom), 0.0);
  }
}

TEST(StudentT, FindsTheQuantileOfEveryTail) {
  for (const double freedom : {1.0, 2.0, 9.0, 82.0, 5000.0}) {
    for (const double tail : {0.4999, 0.2, 0.01, 1e-4, 1e-9}) {
      const double t = student_t_exceeded_with(tail, freedom);
      EXPECT_NEAR(student_t_tail(t, freedom) / tail, 1.0, 1e-9) << freedom << " " << tail;
    }
  }
  for (const std::size_t freedom : {5, 10, 29, 200}) {
    EXPECT_NEAR(student_t_exceeded_with(0.025, static_cast<double>(freedom)), student_t_975(freedom), 2e-5);
  }
}

}  // namespace
}  // namespace cogslam
