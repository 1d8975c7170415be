#pragma once

#include "worlds/occupancy_map.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Whether walls have an inside of their own, as those of a map: the start lies outside of it. Those of a room bound
/// the floor instead.
bool walls_are_thick(const World& world);

/// The cells of a frame that a surface of the world crosses, by the rules of truth_grid, or that lie within what stands
/// there: inside an obstacle, or inside walls that are thick. 1 or 0 each, row-major; the frame may lie anywhere.
std::vector<std::uint8_t> solid_cells(const World& world, const GridFrame& frame);

/// The world as a map: solid cells are occupied, those that can be reached from the start free, others unknown.
/// Read back (map_file.hpp) and made a world (map_contours.hpp) it has the same solid cells in the same frame.
OccupancyMap world_map(const World& world, const GridFrame& frame);
/// Over the world's bounds.
OccupancyMap world_map(const World& world, double cell_size);

}  // namespace cogslam
