#pragma once

#include <cmath>

#include "core/pose2.hpp"
#include "sim/truth.hpp"

namespace cogslam {

/// Notices a vehicle that is told to move and does not: over 5 s it got less than a tenth as far as commanded.
class StuckDetector {
 public:
  /// Takes the state and the twist commanded for the next `dt` seconds.
  void watch(const Truth& truth, const Twist2& commanded, double dt) {
    commanded_way_ += (std::hypot(commanded.x, commanded.y) + kArm * std::abs(commanded.theta)) * dt;
    const Pose2 moved = from_.inverse() * truth.T_map_base;
    const double way = std::hypot(moved.x, moved.y) + kArm * std::abs(moved.theta);
    const bool waited = truth.time - since_ > Duration::from_seconds(kPatience);
    if (way < kJitter && !waited) return;
    stuck_ = way < kJitter && way < 0.1 * commanded_way_;
    from_ = truth.T_map_base;
    since_ = truth.time;
    commanded_way_ = 0.0;
  }

  [[nodiscard]] bool stuck() const { return stuck_; }

 private:
  static constexpr double kArm = 0.2;       ///< makes turning comparable to driving [m]
  static constexpr double kPatience = 5.0;  ///< [s]
  static constexpr double kJitter = 0.05;   ///< a blocked vehicle may still shake by this much [m]

  Pose2 from_{};
  Time since_{};
  double commanded_way_ = 0.0;
  bool stuck_ = false;
};

}  // namespace cogslam
