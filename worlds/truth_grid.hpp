#pragma once

#include <cstdint>

#include "core/grid.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// What a perfect map would say of a cell.
enum class TruthCell : std::uint8_t {
  kFree,          ///< wholly in the floor that can be reached from the start
  kOccupied,      ///< a surface crosses it
  kUnobservable,  ///< neither: within a box, or beyond the walls
};

/// The truth over the bounding rectangle of the world at any cell size [m].
///
/// Cells are half-open, as in GridFrame::cell_of: a surface that lies on a border belongs to the cell above it or to
/// its right, within 1e-9 cells, so that a wall at 0.3 m lies on a border of 0.1 m cells in spite of rounding. Hence a
/// surface along the upper or right border of the whole rectangle marks no cell: keep walls off the borders. A surface
/// that runs on through a corner of cells crosses the two it leads through, and only touches the two beside it.
/// Connectivity is exact (FreeSpace), however wide the cells are.
Grid<TruthCell> truth_grid(const World& world, double cell_size);

/// The cells of any frame that a surface crosses, by the same rules: 1, others 0.
Grid<std::uint8_t> crossed_cells(const World& world, const GridFrame& frame);

}  // namespace cogslam
