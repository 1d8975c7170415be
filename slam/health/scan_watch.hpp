#pragma once

#include <vector>

#include "core/pose2.hpp"
#include "sensors/readings.hpp"
#include "slam/health/filter_health.hpp"

namespace cogslam {

/// Watches the scans as they come: did each come that was due, does a beam come back, is it another one than before?
class ScanWatch {
 public:
  void see(const Reading& reading, FilterHealth& health);

 private:
  std::vector<float> last_ranges_;
  Pose2 T_last_now_{};  ///< motion since that scan was first seen
};

}  // namespace cogslam
