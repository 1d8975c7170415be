#include "slam/health/scan_watch.hpp"

#include <algorithm>
#include <cmath>

namespace cogslam {
namespace {

constexpr double kFewReturns = 0.05;  // share of the beams
// A lidar that tells whole centimetres may repeat a sweep at rest; not after so much motion.
constexpr double kMoved = 0.005;   // [m]
constexpr double kTurned = 0.005;  // [rad]

bool is_blind(const std::vector<float>& ranges) {
  const auto returns = std::count_if(ranges.begin(), ranges.end(), [](float r) { return std::isfinite(r); });
  return static_cast<double>(returns) < kFewReturns * static_cast<double>(ranges.size());
}

}  // namespace

bool ScanWatch::see(const Reading& reading, FilterHealth& health) {
  ++health.records;
  health.by_camera += reading.motion.source == MotionSource::kVisual ? 1 : 0;
  health.by_wheels += reading.motion.source == MotionSource::kWheel ? 1 : 0;
  T_last_now_ = T_last_now_ * reading.motion.T_before_now;
  if (!reading.scan) {
    // Logs of others hold records between their scans; our front end makes one reading per sweep.
    if (reading.motion.source != MotionSource::kLog) ++health.scans_missing;
    return false;
  }
  const std::vector<float>& ranges = reading.scan->ranges;
  if (is_blind(ranges)) ++health.blind_scans;
  // Of a blind scan nothing tells whether it is new.
  if (ranges == last_ranges_ && !is_blind(ranges)) {
    const bool moved = std::hypot(T_last_now_.x, T_last_now_.y) > kMoved || std::abs(T_last_now_.theta) > kTurned;
    if (moved) ++health.repeated_scans;
    return moved;
  }
  last_ranges_ = ranges;
  T_last_now_ = Pose2{};
  return false;
}

}  // namespace cogslam
