#pragma once

#include <optional>

#include "slam/mobile_sensing/offset.hpp"

namespace cogslam {

/// A path out of partial maps: each pose is the one before, moved by what odometry says and corrected by the offset
/// between the two maps (section III.B). Nothing is ever corrected backwards.
class OffsetChain {
 public:
  /// `config` must pass its check().
  OffsetChain(const OffsetConfig& config, const Pose2& start) : config_(config), T_map_base_(start) {}

  /// Takes the map seen after the motion `T_before_now` of odometry. Returns what the comparison with the map before
  /// said; nothing for the first map, which stays at the start.
  std::optional<Offset> push(PartialMap map, const Pose2& T_before_now);

  /// Where the base was when the last map was taken.
  [[nodiscard]] const Pose2& pose() const { return T_map_base_; }

 private:
  OffsetConfig config_;
  Pose2 T_map_base_;
  std::optional<PartialMap> before_;
};

}  // namespace cogslam
