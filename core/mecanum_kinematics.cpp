#include "core/mecanum_kinematics.hpp"

namespace cogslam {

WheelSpeeds wheel_speeds(const MecanumGeometry& geometry, const Twist2& twist) {
  const double per_metre = 1.0 / geometry.wheel_radius, turn = geometry.arm() * twist.theta;
  return {per_metre * (twist.x - twist.y - turn), per_metre * (twist.x + twist.y + turn),
          per_metre * (twist.x + twist.y - turn), per_metre * (twist.x - twist.y + turn)};
}

// The columns of the inverse kinematics are orthogonal, so the pseudo-inverse is its transpose over 4.
Twist2 base_twist(const MecanumGeometry& geometry, const WheelSpeeds& speeds) {
  const auto [fl, fr, rl, rr] = speeds;
  const double share = geometry.wheel_radius / 4.0;
  return {share * (fl + fr + rl + rr), share * (-fl + fr + rl - rr), share / geometry.arm() * (-fl + fr - rl + rr)};
}

double wheel_disagreement(const MecanumGeometry& geometry, const WheelSpeeds& speeds) {
  const auto [fl, fr, rl, rr] = speeds;
  return geometry.wheel_radius / 4.0 * (fl + fr - rl - rr);
}

}  // namespace cogslam
