#pragma once

#include "core/grid.hpp"
#include "slam/mobile_sensing/partial_map.hpp"

namespace cogslam {

/// Two endless walls along the direction `heading` of the frame, each `half_width` cells from its origin and a little
/// over a cell thick, drawn smoothly: 1 in the middle of a wall, 0 far off it.
inline PartialMap drawn_corridor(const GridFrame& frame, double half_width, double heading, double shift) {
  PartialMap map{Grid<double>(frame), Grid<double>(frame, 1.0)};
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const Eigen::Vector2d p = frame.centre_of({x, y}) / frame.cell_size;
      const double across = std::cos(heading) * p.y() - std::sin(heading) * p.x() - shift;
      const double d = std::abs(across) - half_width;
      map.occupancy[{x, y}] = std::exp(-0.5 * d * d);
    }
  }
  return map;
}

}  // namespace cogslam
