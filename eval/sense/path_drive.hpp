#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/sense/path_odometry.hpp"
#include "sensors/lidar_config.hpp"
#include "sensors/readings.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// A robot that drives along straight legs, turns on the spot between them, and stops to look.
struct PathDriveConfig {
  double step_m = 2.0;               ///< from one look to the next, at most; the paper goes up to 4 m
  double step_turn = radians(30.0);  ///< on the spot, at most
  LidarConfig lidar = LidarConfig::lms200();
  OdometryErrorConfig odometry{};

  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

/// One look.
struct PathLook {
  Pose2 T_map_base{};             ///< truth
  Pose2 T_odom_base{};            ///< by odometry, from the same start
  double corridor_heading = 0.0;  ///< of the leg [rad]
  Scan scan;
};

/// Drives through `route` (at least two corners, in the map [m]) in a world; the seed is that of odometry and scanner.
/// Each leg is cut into equal steps.
std::vector<PathLook> drive_path(const World& world, const std::vector<Eigen::Vector2d>& route,
                                 const PathDriveConfig& config, std::uint32_t seed);

}  // namespace cogslam
