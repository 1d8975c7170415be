#include "slam/odometry/wheel_odometry.hpp"

#include <gtest/gtest.h>

#include "core/rng.hpp"

namespace cogslam {
namespace {

WheelSample sample_after(const WheelSample& before, const MecanumGeometry& geometry, const Twist2& twist,
                         double seconds) {
  WheelSample now{.stamp = before.stamp + Duration::from_seconds(seconds), .angles = before.angles};
  const WheelSpeeds speeds = wheel_speeds(geometry, twist);
  for (std::size_t i = 0; i < 4; ++i) now.angles[i] += seconds * speeds[i];
  return now;
}

TEST(WheelOdometry, FollowsTheTwistThatTurnedTheWheels) {
  Rng rng({.seed = 1, .purpose = Purpose::kWorld});
  const MecanumGeometry geometry;
  for (int i = 0; i < 100; ++i) {
    const Twist2 twist{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    const WheelSample before{.angles = {1.0, 2.0, 3.0, 4.0}};
    const MotionIncrement motion = wheel_motion(geometry, {}, before, sample_after(before, geometry, twist, 0.5));
    const Pose2 expected = Pose2::exp(0.5 * twist);
    EXPECT_NEAR(motion.T_before_now.x, expected.x, 1e-12);
    EXPECT_NEAR(motion.T_before_now.y, expected.y, 1e-12);
    EXPECT_NEAR(motion.T_before_now.theta, expected.theta, 1e-12);
    EXPECT_EQ(motion.source, MotionSource::kWheel);
  }
}

TEST(WheelOdometry, VarianceDoesNotDependOnHowTheWayIsCut) {
  const MecanumGeometry geometry;
  const WheelOdometryConfig config{.noise_floor = 1e-9};
  const Twist2 twist{0.3, 0.0, 0.0};
  const WheelSample start, end = sample_after(start, geometry, twist, 1.0);
  const MotionIncrement whole = wheel_motion(geometry, config, start, end);
  const MotionIncrement half = wheel_motion(geometry, config, start, interpolate(start, end, Time::from_seconds(0.5)));
  EXPECT_NEAR(whole.covariance(0, 0), 2.0 * half.covariance(0, 0), 1e-12);
  EXPECT_NEAR(whole.covariance(2, 2), 2.0 * half.covariance(2, 2), 1e-12);
  EXPECT_NEAR(std::sqrt(whole.covariance(0, 0)), config.noise_per_sqrt_metre * std::sqrt(0.3), 1e-9);
}

}  // namespace
}  // namespace cogslam
