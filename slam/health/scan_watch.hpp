#pragma once

#include <vector>

#include "core/pose2.hpp"
#include "sensors/readings.hpp"
#include "slam/health/filter_health.hpp"

namespace cogslam {

/// Watches the scans as they come: did each come that was due, does a beam come back, is it another one than before?
class ScanWatch {
 public:
  /// Whether the scan equals the one before bit by bit although odometry tells of motion since: the lidar is frozen.
  bool see(const Reading& reading, FilterHealth& health);

 private:
  std::vector<float> last_ranges_;
  Pose2 T_last_now_{};  ///< motion since that scan was first seen
};

}  // namespace cogslam
