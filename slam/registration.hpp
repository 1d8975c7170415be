#pragma once

#include <cmath>

#include "core/pose2.hpp"

namespace cogslam {

/// When a scan is registered (matched, weighed, put into the map) and not only tracked (odometry moves the pose).
struct RegistrationConfig {
  double distance = 0.1;  ///< after so much travel [m]
  double turn = 0.1;      ///< or after so much turning [rad]

  /// At a standstill nothing is registered: the same wall seen again from the same place is no new evidence.
  [[nodiscard]] bool due(const Pose2& T_last_now) const {
    return std::hypot(T_last_now.x, T_last_now.y) >= distance || std::abs(T_last_now.theta) >= turn;
  }
};

}  // namespace cogslam
