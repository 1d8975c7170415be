#pragma once

#include <numbers>
#include <optional>

#include "slam/sweep.hpp"
#include "slam/track/point_to_line.hpp"

namespace cogslam {

/// How every scan refines the motion that odometry tells.
struct TrackerConfig {
  bool used = true;
  int beams = 361;                     ///< at most so many are paired, evenly spread over the scan
  double gap = 0.4;                    ///< beams that end nearer than this to each other may lie on one wall [m]
  int keys = 10;                       ///< scans in the local map
  double cell = 0.05;                  ///< of the local map: one mean point per cell [m]
  double turn_step = 0.1;              ///< after an uncertain turn the search starts from headings so far apart [rad]
  double inflation = 3.0;              ///< odometry's standard deviations times this
  double least_sigma_position = 0.03;  ///< per scan, however sure odometry is [m]
  double least_sigma_heading = 0.005;  ///< [rad]
  double spread = 0.5;                 ///< of motion: the match's standard deviations times this
  double spread_position = 0.002;      ///< and so much more [m]
  double spread_heading = 0.08 * std::numbers::pi / 180.0;  ///< [rad]
  PointToLineConfig match{};

  /// Throws InputError when the parts contradict each other.
  void check() const;
};

/// Follows the robot from scan to scan: odometry predicts, and the scan's surface points are matched with a local map
/// of the last key scans. Shared by all particles: what differs between their paths lies farther back.
class ScanTracker {
 public:
  ScanTracker(const TrackerConfig& config, const SweepConfig& sweep);

  /// Takes the next reading.
  void follow(const Reading& reading);
  /// Makes the last scan a key scan: it joins the local map, and motion is told from there on.
  void make_key();

  /// The path of the tracker alone: its errors add up.
  [[nodiscard]] Pose2 T_track_base() const { return T_track_scan_ * T_scan_now_; }
  /// Motion since the last key scan, and its covariance: of the match at the last scan, joined with odometry's since.
  [[nodiscard]] Pose2 T_key_now() const { return T_track_key_.inverse() * T_track_base(); }
  [[nodiscard]] Eigen::Matrix3d covariance() const;
  /// What a particle's motion is drawn with: the same times `spread`, and the least of it. Less than the covariance,
  /// because tracking errs the same way at every scan that sees the same walls.
  [[nodiscard]] Eigen::Matrix3d spread() const;

  [[nodiscard]] std::int64_t bytes() const { return map_.bytes(); }

 private:
  void match(const Reading& reading);
  [[nodiscard]] Eigen::Matrix3d motion_covariance() const;
  [[nodiscard]] PointToLineMatch search_turns(const Pose2& predicted, const Eigen::Matrix3d& covariance) const;
  [[nodiscard]] PointToLineMatch search_wide(const Pose2& predicted, const Eigen::Matrix3d& covariance) const;
  [[nodiscard]] PointToLineMatch best_match(const std::vector<Pose2>& starts, const Pose2& predicted,
                                            const Eigen::Matrix3d& covariance) const;

  TrackerConfig config_;
  SweepConfig sweep_;
  LocalMap map_;
  std::vector<Beam> beams_;           ///< of the last scan
  std::vector<SurfacePoint> points_;  ///< of the last scan, in its base frame
  Pose2 T_track_key_{};
  Pose2 T_track_scan_{};                                       ///< of the last scan
  Eigen::Matrix3d scan_covariance_ = Eigen::Matrix3d::Zero();  ///< of it, against the local map
  Pose2 T_scan_now_{};                                         ///< by odometry
  Eigen::Matrix3d since_scan_ = Eigen::Matrix3d::Zero();
  std::optional<Pose2> lagging_;  ///< T_track_base by odometry alone, since the scan before it was found to lag
};

}  // namespace cogslam
