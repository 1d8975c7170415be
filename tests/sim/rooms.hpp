#pragma once

#include "worlds/world.hpp"

namespace cogslam {

/// An empty rectangular room around the origin, the vehicle in its middle [m].
inline World empty_room(double length, double width) {
  World world;
  const double x = length / 2.0, y = width / 2.0;
  world.walls = {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
  return world;
}

/// The corners of a box turned by `angle` about its middle [m, rad].
inline Polygon box(const Eigen::Vector2d& middle, double length, double width, double angle = 0.0) {
  const Pose2 T_map_box{middle.x(), middle.y(), angle};
  Polygon corners;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    corners.push_back(T_map_box * Eigen::Vector2d(x * length, y * width));
  }
  return corners;
}

}  // namespace cogslam
