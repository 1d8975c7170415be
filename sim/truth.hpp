#pragma once

#include "core/mecanum_kinematics.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"

namespace cogslam {

/// The state of the vehicle at one moment, without error.
struct Truth {
  Time time{};
  Pose2 T_map_base{};
  Twist2 twist{};  ///< of the base, in its own frame [m/s, m/s, rad/s]
  WheelSpeeds wheel_speeds{};
  WheelValues wheel_angles{};  ///< turned since time 0 [rad], for the encoders
  bool in_contact = false;     ///< touches a wall or a box
};

}  // namespace cogslam
