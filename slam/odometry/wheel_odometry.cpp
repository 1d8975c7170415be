#include "slam/odometry/wheel_odometry.hpp"

#include <cmath>

#include "core/check.hpp"

namespace cogslam {

MotionIncrement wheel_motion(const MecanumGeometry& geometry, const WheelOdometryConfig& config,
                             const WheelSample& before, const WheelSample& now) {
  WheelValues turned{};
  for (std::size_t i = 0; i < turned.size(); ++i) turned[i] = now.angles[i] - before.angles[i];
  const Twist2 motion = base_twist(geometry, turned);
  const double way = std::hypot(motion.x, motion.y), turn = std::abs(motion.theta);
  const auto squared = [](double x) { return x * x; };
  const double position = squared(config.noise_per_sqrt_metre) * way + squared(config.noise_floor);
  const double heading = squared(config.turn_noise_per_sqrt_metre) * way +
                         squared(config.turn_noise_per_sqrt_radian) * turn + squared(config.noise_floor);
  MotionIncrement increment{.T_before_now = Pose2::exp(motion), .source = MotionSource::kWheel};
  increment.covariance.diagonal() = Eigen::Vector3d(position, position, heading);
  return increment;
}

WheelSample interpolate(const WheelSample& a, const WheelSample& b, Time stamp) {
  EXPECTS(a.stamp < b.stamp);
  const double w = (stamp - a.stamp).seconds() / (b.stamp - a.stamp).seconds();
  WheelSample between{.stamp = stamp};
  for (std::size_t i = 0; i < between.angles.size(); ++i)
    between.angles[i] = a.angles[i] + w * (b.angles[i] - a.angles[i]);
  return between;
}

}  // namespace cogslam
