#pragma once

#include <Eigen/Core>

#include "core/config.hpp"
#include "core/pose2.hpp"

namespace cogslam {

/// How far the odometry of an unknown robot is to be trusted. Variances grow with the way and with the turn, so that it
/// does not matter into how many records a drive is cut:
///
///   var(x) = var(y) = position_per_m^2 d + position_per_rad^2 a + position_floor^2
///   var(theta)      = heading_per_m^2 d  + heading_per_rad^2 a  + heading_floor^2
///
/// with d the way [m] and a the turn [rad] between two records. No correlations. After Thrun, Burgard and Fox,
/// Probabilistic Robotics, 5.4; the figures are for an indoor robot on two wheels.
struct OdometryNoise {
  double position_per_m = 0.03;           ///< standard deviation after 1 m [m]
  double position_per_rad = 0.01;         ///< after 1 rad [m]
  double heading_per_m = radians(4.0);    ///< after 1 m [rad]
  double heading_per_rad = radians(4.0);  ///< after 1 rad [rad]
  double position_floor_m = 0.0002;       ///< of any step, also at rest
  double heading_floor = radians(0.02);   ///< of any step, also at rest [rad]

  /// Of the small motion that follows `T_before_now` [m^2, m^2, rad^2].
  [[nodiscard]] Eigen::Matrix3d covariance(const Pose2& T_before_now) const;
};

OdometryNoise read_odometry_noise(ConfigSection& section);

}  // namespace cogslam
