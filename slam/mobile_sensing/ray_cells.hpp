#pragma once

#include <cstddef>
#include <cstdint>

#include "slam/mobile_sensing/cell_samples.hpp"

namespace cogslam {

/// Choosing cells as a laser meets them: from random free places along random rays, keeping where a ray ends at a wall
/// and one cell that it crossed on the way. Rays start anywhere, so no path is planned; a cell counts once.
struct RayCells {
  double range_cells = 32.0;    ///< 8 m in cells of 0.25 m, > 0
  double occupied_from = 0.75;  ///< value that stops a ray
  int tries_per_cell = 100;     ///< rays cast before giving up, per cell asked for
};

/// Senses `count` <= width * height cells. Throws InputError where rays meet too few different cells: what lies behind
/// walls is never seen.
[[nodiscard]] CellSamples sense_ray_cells(const RayCells& plan, int width, int height, std::size_t count,
                                          std::uint32_t seed, const CellSensor& sensor);

}  // namespace cogslam
