#pragma once

#include "worlds/world.hpp"

namespace cogslam {

/// Distance from `p_map` to the nearest surface [m].
double clearance(const World& world, const Eigen::Vector2d& p_map);

/// Smallest distance between a straight way and any surface [m]; 0 where it crosses one.
double clearance(const World& world, const Segment& way);

/// How much of its floor a round robot can use.
struct Reach {
  double free_area = 0.0;       ///< floor that can be reached by a point [m^2]
  double standing_area = 0.0;   ///< of that: where the centre of the robot can stand [m^2]
  double reachable_area = 0.0;  ///< of that: where it can drive to from the start [m^2]
};

/// Floods the floor of a closed world with a robot of `radius` [m] on a raster of `step` [m], eight ways to go from
/// each point. Distances at the raster points are exact; lanes are decided to about one step.
Reach reach(const World& world, double radius, double step = 0.05);

}  // namespace cogslam
