#pragma once

#include "core/mecanum_kinematics.hpp"
#include "sensors/readings.hpp"

namespace cogslam {

/// How far wheels are to be trusted. Variances grow with the way and the turn, so it does not matter into how many
/// increments a way is cut.
struct WheelOdometryConfig {
  double noise_per_sqrt_metre = 0.05;        ///< position [m] after one metre
  double turn_noise_per_sqrt_metre = 0.05;   ///< heading [rad] after one metre
  double turn_noise_per_sqrt_radian = 0.05;  ///< heading [rad] after a turn of one radian
  double noise_floor = 1e-4;                 ///< position [m] and heading [rad] of any increment: encoder steps
};

/// Motion of the base between two wheel samples, by forward kinematics at constant speed between them. Rollers slip
/// more than wheels: this is the fallback where the camera sees nothing.
MotionIncrement wheel_motion(const MecanumGeometry& geometry, const WheelOdometryConfig& config,
                             const WheelSample& before, const WheelSample& now);

/// The sample that constant wheel speeds between `a` and `b` give at `stamp`, which may lie outside.
WheelSample interpolate(const WheelSample& a, const WheelSample& b, Time stamp);

}  // namespace cogslam
