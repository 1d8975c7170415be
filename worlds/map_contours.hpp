#pragma once

#include "worlds/occupancy_map.hpp"
#include "worlds/world.hpp"

namespace cogslam {

struct MapContourConfig {
  bool unknown_is_solid = false;  ///< unknown cells, and all beyond the image, stand as walls
  double simplify = 0.0;          ///< how far a surface may run beside the cells' own [m]; 0: not at all
};

/// Corners of the outline of the solid cells, two where squares touch at a corner: about as many as the loops will
/// have. Needs no memory, so it may be asked of any picture first.
std::size_t count_corners(const OccupancyMap& map, bool unknown_is_solid);

/// Surfaces of the occupied cells of a map, as walls and obstacles of a world without a start.
///
/// Each border of a group of cells that touch (by sides or corners), its outer one and those of its holes, becomes a
/// loop through the *centres* of the cells along it (Suzuki & Abe 1985, cv::findContours); straight runs are one edge.
/// So a hit on a surface falls into the cell that was occupied, not on its border, a wall one cell thick is a surface
/// without thickness, and cells that touch at a corner leave no gap. Against the squares of the cells a surface is
/// back by at most half a cell at a side, by 0.71 cells in an inner corner. A cell alone becomes a box of half its
/// side. Groups with holes are walls, others obstacles. With `simplify` = 0 the surfaces cross the cells along the
/// borders and no others, and solid_cells (world_map.hpp) gives back all occupied ones. Otherwise loops are thinned out
/// (Douglas & Peucker 1973, cv::approxPolyDP), and each corner taken out lies within `simplify` of what is left.
World map_contours(const OccupancyMap& map, const MapContourConfig& config = {});

}  // namespace cogslam
