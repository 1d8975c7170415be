#pragma once

#include "sensors/lidar.hpp"

namespace cogslam {

/// Sweep number `index` of a lidar on a base that stands still.
inline Scan look_from(const Lidar& lidar, const Pose2& T_map_base, std::uint64_t index) {
  const Duration stand = Duration{2 * lidar.sweep_time().ns + 1};
  PoseTrack still(stand);
  Truth truth{};
  truth.T_map_base = T_map_base;
  still.push(truth);
  truth.time = Time{} + stand;
  still.push(truth);
  return lidar.sweep(still, Time{}, index).scan;
}

}  // namespace cogslam
