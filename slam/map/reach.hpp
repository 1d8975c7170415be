#pragma once

#include "slam/map/cell_window.hpp"

namespace cogslam {

/// As many cells as a map may have: 1 GB of floats.
constexpr double kMostMapCells = 268435456.0;  // 2^28
/// As far as a map may lie from the origin: lattice coordinates are int [cells].
constexpr double kFarthestCell = 1e9;

/// Throws InputError where a map, or the part of it that a scan may touch, would have more than kMostMapCells cells.
/// Odometry that jumps is the usual reason.
void check_reach(const CellWindow& window);

}  // namespace cogslam
