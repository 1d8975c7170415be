#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "slam/map/memory_meter.hpp"
#include "slam/stored_pose.hpp"

namespace cogslam {

/// Where one particle's path puts the scans that wait (waiting_scans.hpp), oldest first. They are not in the path tree
/// yet: a closed loop moves them, and for every particle by another way.
class WaitingPoses {
 public:
  void add(const Pose2& T_map_base) { poses_.emplace_back(T_map_base); }
  /// Adds the newest and takes out the oldest, which is the newest itself where none waits.
  StoredPose exchange(const Pose2& newest) {
    if (poses_.empty()) return StoredPose(newest);
    const StoredPose oldest = poses_.front();
    poses_.erase(poses_.begin());
    add(newest);
    return oldest;
  }
  /// Each becomes T * pose.
  void move(const Pose2& T) {
    for (StoredPose& pose : poses_) pose = StoredPose(T * pose.pose());
  }

  [[nodiscard]] std::size_t size() const { return poses_.size(); }
  [[nodiscard]] Pose2 operator[](std::size_t i) const { return poses_[i].pose(); }
  [[nodiscard]] std::int64_t bytes() const { return heap_bytes(poses_.capacity() * sizeof(StoredPose)); }

 private:
  std::vector<StoredPose> poses_;
};

}  // namespace cogslam
