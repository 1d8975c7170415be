#pragma once

#include <span>
#include <string>

#include "core/pose2.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Paths in the map frame; an empty one is left out of the picture and its legend.
struct DrawnPaths {
  std::span<const Pose2> truth;
  std::span<const Pose2> odometry;
  std::span<const Pose2> estimate;
};

/// The room seen from above with the paths through it, as a PNG file in memory (write it with core/output_file.hpp).
/// The map's x axis points to the right, its y axis up; a blue dot marks the start. A world without surfaces (a log)
/// shows the paths alone. The room's shorter side is 700 pixels unless it is very long. Poses that are not finite are
/// left out.
std::string room_picture(const World& world, const DrawnPaths& paths);

}  // namespace cogslam
