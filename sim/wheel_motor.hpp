#pragma once

#include <algorithm>

#include "sim/robot_config.hpp"

namespace cogslam {

/// The speed controller of one wheel.
class WheelMotor {
 public:
  /// Torque on the wheel [N m] for the next `dt` seconds, within the limit of `config`.
  double torque(const MotorConfig& config, double set_point, double speed, double dt) {
    const double error = set_point - speed;
    const double wanted = config.kp * error + integral_ + config.ki * error * dt;
    const double limited = std::clamp(wanted, -config.max_torque, config.max_torque);
    // At the limit the integral only moves back: a blocked wheel must not save up a burst for later.
    if (wanted == limited || error * wanted < 0.0) integral_ += config.ki * error * dt;
    return limited;
  }

  void reset() { integral_ = 0.0; }

 private:
  double integral_ = 0.0;  ///< [N m]
};

}  // namespace cogslam
