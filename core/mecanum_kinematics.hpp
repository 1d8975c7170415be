#pragma once

#include <array>

#include "core/pose2.hpp"

namespace cogslam {

/// One value per wheel. Order everywhere: front left, front right, rear left, rear right.
using WheelValues = std::array<double, 4>;
using WheelSpeeds = WheelValues;  ///< [rad/s], positive drives forward

/// Where the four wheels stand and how large they are; rollers in X arrangement (seen from above, the axes of the
/// rollers that touch the floor point at the middle of the vehicle).
struct MecanumGeometry {
  double wheel_radius = 0.05;  ///< [m]
  double half_length = 0.15;   ///< from the middle to an axle, along x [m]
  double half_width = 0.13;    ///< from the middle to a wheel's middle, along y [m]

  /// The arm by which wheels turn the vehicle [m].
  [[nodiscard]] double arm() const { return half_length + half_width; }
};

/// Wheel speeds at which no roller slips while the base moves with `twist` (inverse kinematics):
/// r w = vx -+ vy -+ (half_length + half_width) omega (Muir & Neuman 1987).
WheelSpeeds wheel_speeds(const MecanumGeometry& geometry, const Twist2& twist);

/// The twist that fits four wheel speeds best (forward kinematics): least squares of the four slips, since four wheels
/// say more than three degrees of freedom need. `base_twist(g, wheel_speeds(g, v)) == v`. Linear, so wheel angles in
/// [rad] instead of speeds give the small motion in [m, m, rad].
Twist2 base_twist(const MecanumGeometry& geometry, const WheelSpeeds& speeds);

/// What least squares cannot explain: slip [m/s] that each wheel has at `base_twist`, up to sign. Zero for wheels that
/// agree; of wheel angles in [rad] it is a length [m].
double wheel_disagreement(const MecanumGeometry& geometry, const WheelSpeeds& speeds);

}  // namespace cogslam
