#pragma once

#include <cmath>

#include "core/rng.hpp"
#include "worlds/world.hpp"

namespace cogslam {

inline Polygon rectangle(const Eigen::Vector2d& min, const Eigen::Vector2d& max) {
  return {min, {max.x(), min.y()}, max, {min.x(), max.y()}};
}

/// An empty room of `side` x `side` [m] around the origin.
inline World square_room(double side) {
  World world;
  world.walls = {rectangle({-side / 2, -side / 2}, {side / 2, side / 2})};
  return world;
}

/// A room of 10 x 10 m around the origin with turned boxes of 0.2-0.8 m anywhere in it but within 1 m of the origin.
inline World room_with_boxes(int boxes, std::uint32_t seed) {
  World world = square_room(10.0);
  Rng rng({seed, Purpose::kWorld, 0, 0});
  while (static_cast<int>(world.obstacles.size()) < boxes) {
    const Pose2 T_map_box{rng.uniform(-4.5, 4.5), rng.uniform(-4.5, 4.5), rng.uniform(-3.0, 3.0)};
    const double w = rng.uniform(0.1, 0.4), h = rng.uniform(0.1, 0.4);
    if (T_map_box.position().norm() < 1.6) continue;
    Polygon box = rectangle({-w, -h}, {w, h});
    for (Eigen::Vector2d& corner : box) corner = T_map_box * corner;
    world.obstacles.push_back(box);
  }
  return world;
}

}  // namespace cogslam
