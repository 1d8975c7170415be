#pragma once

#include "core/pose2.hpp"
#include "slam/map/store.hpp"
#include "slam/waiting_poses.hpp"
#include "slam/weight/compass_likelihood.hpp"

namespace cogslam {

/// One hypothesis: where the robot is, how it got there, and what the world looks like if so (eqs. 3, 16).
struct Particle {
  Pose2 T_map_base{};
  double log_weight = 0.0;       ///< since the last resampling
  double path_log_weight = 0.0;  ///< since the start, along its path
  WaitingPoses waiting{};        ///< of the scans that are not in the map yet
  StoredPose entering{};         ///< of the scan that enters the map in this step, if one is due
  CompassBias compass_bias{};
  MapStore map;  ///< shared with other particles until one of them writes
};

}  // namespace cogslam
