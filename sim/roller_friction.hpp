#pragma once

#include "core/mecanum_kinematics.hpp"
#include "sim/robot_config.hpp"

namespace cogslam {

/// What happened between one wheel and the floor in one step.
struct WheelContact {
  double slip = 0.0;     ///< of the rim against the floor, along the roller's axis, after the step [m/s]
  double impulse = 0.0;  ///< of the floor on the vehicle, along the roller's axis [N s]
  double limit = 0.0;    ///< |impulse| <= limit = friction x load x step [N s]
};
using WheelContacts = std::array<WheelContact, 4>;

/// Dry friction between four Mecanum wheels and the floor, as impulses.
///
/// A roller turns freely about its axis a, so the floor holds a wheel along a only. The four conditions "no slip along
/// a_i unless the impulse is at its limit" are solved by projected Gauss-Seidel, started from the impulses of the step
/// before. They are coupled through the body and through the wheels' own inertia, so the velocities come out stable at
/// any step, where friction as a force of the slip would chatter.
class RollerFriction {
 public:
  explicit RollerFriction(const RobotConfig& config);

  /// Changes `twist` (of the base, in its own frame) and `speeds` by the impulses of one step. The wheels roll on the
  /// radii `radius` [m], and wheel i's impulse stays within `limit[i]` [N s].
  const WheelContacts& solve(const WheelValues& radius, const WheelValues& limit, Twist2& twist, WheelSpeeds& speeds);

  [[nodiscard]] const WheelContacts& contacts() const { return contacts_; }
  /// Where wheel i stands, in the base frame [m].
  [[nodiscard]] const Eigen::Vector2d& wheel_position(std::size_t i) const { return rollers_[i].position; }

 private:
  struct Roller {
    Eigen::Vector2d position;  ///< in the base frame [m]
    Eigen::Vector2d axis;      ///< unit vector
    double arm;                ///< position x axis [m]
  };
  struct Bodies;  // the velocities while they are being solved

  std::array<Roller, 4> rollers_;
  double per_mass_, per_inertia_, per_wheel_inertia_;
  WheelContacts contacts_{};
};

}  // namespace cogslam
