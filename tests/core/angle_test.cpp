#include "core/angle.hpp"

#include <gtest/gtest.h>

#include "core/rng.hpp"

namespace cogslam {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Angle, WrapsIntoTheHalfOpenTurn) {
  EXPECT_EQ(wrap_angle(kPi), kPi);
  EXPECT_EQ(wrap_angle(-kPi), kPi);
  EXPECT_EQ(wrap_angle(0.0), 0.0);
  EXPECT_NEAR(wrap_angle(3.0 * kPi), kPi, 1e-15);
  EXPECT_NEAR(wrap_angle(1.5 * kPi), -0.5 * kPi, 1e-15);
  EXPECT_NEAR(wrap_angle(-1.5 * kPi), 0.5 * kPi, 1e-15);
}

TEST(Angle, WrapKeepsTheDirectionOfAnyAngle) {
  Rng rng({.seed = 1, .purpose = Purpose::kWorld});
  for (int i = 0; i < 10000; ++i) {
    const double angle = rng.uniform(-1000.0, 1000.0);
    const double wrapped = wrap_angle(angle);
    ASSERT_GT(wrapped, -kPi) << angle;
    ASSERT_LE(wrapped, kPi) << angle;
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12) << angle;
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12) << angle;
  }
}

TEST(Angle, DifferenceTakesTheShortWay) {
  EXPECT_NEAR(angle_difference(radians(-179.0), radians(179.0)), radians(2.0), 1e-15);
  EXPECT_NEAR(angle_difference(radians(179.0), radians(-179.0)), radians(-2.0), 1e-15);
  EXPECT_NEAR(angle_difference(radians(30.0), radians(50.0)), radians(-20.0), 1e-15);
}

TEST(Angle, DegreesAreTheOtherWayRound) {
  EXPECT_DOUBLE_EQ(radians(180.0), kPi);
  EXPECT_DOUBLE_EQ(degrees(kPi / 6.0), 30.0);
}

}  // namespace
}  // namespace cogslam
