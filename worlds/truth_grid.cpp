#include "worlds/truth_grid.hpp"

#include <cmath>
#include <utility>

#include "core/cell_walk.hpp"
#include "core/check.hpp"
#include "worlds/free_space.hpp"

namespace cogslam {
namespace {

constexpr double kSame = 1e-9;  // [cells]

double snapped(double cells) {
  const double border = std::round(cells);
  return std::abs(cells - border) < kSame ? border : cells;
}

void mark_surface(const Segment& s, Grid<TruthCell>& grid) {
  const GridFrame& frame = grid.frame();
  const auto in_cells = [&frame](const Eigen::Vector2d& p) {
    return Eigen::Vector2d{snapped(p.x() / frame.cell_size) - frame.lattice_min.x,
                           snapped(p.y() / frame.cell_size) - frame.lattice_min.y};
  };
  Eigen::Vector2d from = in_cells(s.a), to = in_cells(s.b);
  // From left to right, the walk makes one step too many only where the segment rises exactly through a corner.
  if (to.x() < from.x()) std::swap(from, to);
  const bool rises = to.y() > from.y() && to.x() > from.x();
  const double slope = rises ? (to.y() - from.y()) / (to.x() - from.x()) : 0.0;
  walk_cells(from, to, [&](Cell c) {
    const bool passes_above = rises && c.x >= from.x() && from.y() + slope * (c.x - from.x()) > c.y + 1 - kSame;
    if (frame.contains(c) && !passes_above) grid[c] = TruthCell::kOccupied;
    return true;
  });
}

}  // namespace

Grid<TruthCell> truth_grid(const World& world, double cell_size) {
  EXPECTS(cell_size > 0.0);
  Grid<TruthCell> grid(GridFrame::covering(world.bounds(), cell_size), TruthCell::kUnobservable);
  for (const Segment& s : world.segments()) mark_surface(s, grid);

  const FreeSpace free_space(world);
  const GridFrame& frame = grid.frame();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      // No surface crosses the cell, so its centre speaks for all of it.
      const Cell c{x, y};
      if (grid[c] != TruthCell::kOccupied && free_space.contains(frame.centre_of(c))) grid[c] = TruthCell::kFree;
    }
  }
  return grid;
}

}  // namespace cogslam
