#pragma once

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "sensors/readings.hpp"
#include "slam/health/filter_health.hpp"

namespace cogslam {

/// Compares the motion that odometry tells with that of the scans, stretch by stretch of 0.1 m or 0.1 rad.
class OdometryWatch {
 public:
  /// `T_track_base`: where the tracker has the base after this reading's scan.
  void see(const MotionIncrement& motion, const Pose2& T_track_base, bool scan, FilterHealth& health);

  /// How far the last stretch was off, in units of its tolerance; for tests and for tuning it.
  [[nodiscard]] double last_miss() const { return miss_; }

 private:
  Pose2 T_track_start_{};
  Pose2 T_start_now_{};  ///< by odometry
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  double miss_ = 0.0;
};

}  // namespace cogslam
