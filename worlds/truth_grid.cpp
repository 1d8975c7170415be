#include "worlds/truth_grid.hpp"

#include <algorithm>
#include <cmath>

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

Cell floor_of(const Eigen::Vector2d& p) {
  return {static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
}

/// Whether the line from `from` to `to` passes a cell by, touching no more than a corner of it. Told of cells between
/// the first and the last only, where that means a corner that the line runs on through.
bool passes_by(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Cell c) {
  if (from.x() == to.x() || from.y() == to.y()) return false;
  const double slope = (to.y() - from.y()) / (to.x() - from.x());
  const double on_left = from.y() + slope * (std::max<double>(c.x, std::min(from.x(), to.x())) - from.x());
  const double on_right = from.y() + slope * (std::min<double>(c.x + 1, std::max(from.x(), to.x())) - from.x());
  return std::max(on_left, on_right) < c.y + kSame || std::min(on_left, on_right) > c.y + 1 - kSame;
}

void mark_surface(const Segment& s, Grid<std::uint8_t>& grid) {
  const GridFrame& frame = grid.frame();
  const auto in_cells = [&frame](const Eigen::Vector2d& p) {
    return Eigen::Vector2d{snapped(p.x() / frame.cell_size) - frame.lattice_min.x,
                           snapped(p.y() / frame.cell_size) - frame.lattice_min.y};
  };
  const Eigen::Vector2d from = in_cells(s.a), to = in_cells(s.b);
  const Cell first = floor_of(from), last = floor_of(to);
  walk_cells(from, to, [&](Cell c) {
    const bool between = c != first && c != last;
    if (frame.contains(c) && !(between && passes_by(from, to, c))) grid[c] = 1;
    return true;
  });
}

}  // namespace

Grid<std::uint8_t> crossed_cells(const World& world, const GridFrame& frame) {
  Grid<std::uint8_t> crossed(frame);
  for (const Segment& s : world.segments()) mark_surface(s, crossed);
  return crossed;
}

Grid<TruthCell> truth_grid(const World& world, double cell_size) {
  EXPECTS(cell_size > 0.0);
  const GridFrame frame = GridFrame::covering(world.bounds(), cell_size);
  Grid<TruthCell> grid(frame, TruthCell::kUnobservable);
  const Grid<std::uint8_t> crossed = crossed_cells(world, frame);
  const FreeSpace free_space(world);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const Cell c{x, y};
      if (crossed[c] != 0) {
        grid[c] = TruthCell::kOccupied;
      } else if (free_space.contains(frame.centre_of(c))) {  // no surface crosses it: its centre speaks for all of it
        grid[c] = TruthCell::kFree;
      }
    }
  }
  return grid;
}

}  // namespace cogslam
