#pragma once

#include <vector>

#include "worlds/world.hpp"

namespace cogslam {

/// The floor of an office building, in the manner of Hu and Tan's hallway: 62.25 m x 38.5 m, that is 249 x 154 cells of
/// 0.25 m, walls 0.1 m off the borders of such cells. A ring of corridors 2.4 m wide with open rooms, door niches and
/// pilasters along it, and a plain corridor, without any, across its middle. The start looks along the lower hallway.
World hallway();

/// Where a robot is driven: once round the ring, then through the lower hallway and up the plain corridor. Corners of a
/// path in the middle of the corridors [m]; the first is the start.
std::vector<Eigen::Vector2d> hallway_route();

}  // namespace cogslam
