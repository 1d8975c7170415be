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
/// surface along the upper or right border of the whole rectangle marks no cell: keep walls off the borders.
/// Connectivity is exact (FreeSpace), however wide the cells are.
Grid<TruthCell> truth_grid(const World& world, double cell_size);

}  // namespace cogslam
