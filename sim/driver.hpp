#pragma once

#include <optional>

#include "sim/drive_config.hpp"
#include "sim/stuck_detector.hpp"
#include "sim/truth.hpp"

namespace cogslam {

/// The remote operator: sees where the vehicle truly is, and steers it along a route or through a script.
class Driver {
 public:
  explicit Driver(DriveConfig config);

  /// The twist to command now, of the base in its own frame. To be called with a truth per physics step, or less
  /// often, in order of time.
  Twist2 command(const Truth& truth);

  /// Whether the vehicle was blocked for the last 5 s although it was told to move.
  [[nodiscard]] bool stuck() const { return stuck_.stuck(); }
  /// Waypoints reached since the start, or parts of the script completed.
  [[nodiscard]] int legs_done() const { return legs_done_; }

 private:
  [[nodiscard]] Twist2 scripted(Time time);
  [[nodiscard]] Twist2 towards_waypoint(const Truth& truth, double dt);
  [[nodiscard]] const Waypoint& waypoint() const;
  [[nodiscard]] bool arrived(const Pose2& T_map_base) const;
  void start_leg(const Pose2& T_map_base);

  DriveConfig config_;
  StuckDetector stuck_;
  std::optional<Time> last_time_;
  int legs_done_ = 0;
  Time part_start_{};                    ///< of the scripted twist under way
  std::optional<double> leg_heading_{};  ///< held on this leg [rad]; nothing while it turns
  Eigen::Vector2d velocity_{0.0, 0.0};   ///< commanded last, in the map frame [m/s]
  double yaw_rate_ = 0.0;                ///< commanded last [rad/s]
};

}  // namespace cogslam
