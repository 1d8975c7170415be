#include "core/time.hpp"

#include <gtest/gtest.h>

namespace cogslam {
namespace {

TEST(Time, RoundsSecondsToTheNearestNanosecond) {
  EXPECT_EQ(Duration::from_seconds(0.1).ns, 100'000'000);
  EXPECT_EQ(Duration::from_seconds(-1.4e-9).ns, -1);
  EXPECT_EQ(Time::from_seconds(1.6e-9).ns, 2);
  // A stamp of a real log: a double holds it to about 100 ns.
  EXPECT_NEAR(static_cast<double>(Time::from_seconds(976052857.337530).ns - 976052857'337530000), 0.0, 128.0);
}

TEST(Time, AddsExactlyWhereSecondsWouldDrift) {
  Time t;
  double seconds = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    t = t + Duration::from_seconds(0.001);
    seconds += 0.001;
  }
  EXPECT_EQ(t, Time::from_seconds(1000.0));
  EXPECT_NE(seconds, 1000.0);
}

TEST(Time, MomentsAndSpansObeyTheirLaws) {
  const Time a{5}, b{12};
  const Duration d = b - a;
  EXPECT_EQ(d.ns, 7);
  EXPECT_EQ(a + d, b);
  EXPECT_EQ(b - d, a);
  EXPECT_EQ(3 * d, Duration{21});
  EXPECT_EQ(d + d - d, d);
  EXPECT_LT(a, b);
}

}  // namespace
}  // namespace cogslam
