#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "slam/registered_pose.hpp"

namespace cogslam {

/// When a loop closes, and how far tracking may have drifted since the filter last knew its place.
struct LoopConfig {
  int waiting_scans = 20;                                 ///< registered scans that wait before they enter the maps
  double drift_position = 0.02;                           ///< of tracking after 1 m of travel [m]; grows with its root
  double drift_heading = 0.2 * std::numbers::pi / 180.0;  ///< [rad]
  double known_share = 0.4;  ///< of the drift's variance, while the old map is in sight; in [0, 1]
  double sight = 4.0;        ///< the old map is in sight this near to an old pose [m]
  double least_way = 50.0;   ///< a pose is old after so much travel [m]
};

/// The drift of the tracked path since the filter last saw its old map: the noise of the motion that nothing could
/// weigh yet. It is kept as a covariance instead of being drawn at every step: local motion stays as good as tracking,
/// and when the old map comes in sight, the match may search as far as the drift reaches. One for all particles, whose
/// motion is the same but for what they draw.
class LoopDrift {
 public:
  explicit LoopDrift(const LoopConfig& config) : config_(config) {}

  /// Takes the motion between the registered scan before and this one.
  void move(const Pose2& T_last_now);
  /// Takes whether the old map is in sight at this scan: if so, what was kept is released.
  void look(bool old_map_in_sight);

  /// Whether the registered scan with this number (from 0) lies far enough back on the way to call its place old.
  [[nodiscard]] bool is_old(std::size_t registered) const;
  /// Whether a robot at T_map_base is near an old pose of its path, which holds all registered scans, oldest first.
  [[nodiscard]] bool old_map_in_sight(const Pose2& T_map_base, std::span<const RegisteredPose> path) const;

  /// What the spread of this scan's motion grows by: of the small motion that follows it [m, m, rad]. Zero while no
  /// old map is in sight.
  [[nodiscard]] const Eigen::Matrix3d& released() const { return released_; }
  /// The drift released here is so wide that the scans which still wait lie wrong with it.
  [[nodiscard]] bool closes_loop() const;

  [[nodiscard]] std::int64_t bytes() const { return static_cast<std::int64_t>(ways_.capacity() * sizeof(ways_[0])); }

 private:
  LoopConfig config_;
  Eigen::Matrix3d kept_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d added_ = Eigen::Matrix3d::Zero();  ///< by the last motion
  Eigen::Matrix3d released_ = Eigen::Matrix3d::Zero();
  std::vector<float> ways_;  ///< travelled at each registered scan [m]
};

}  // namespace cogslam
