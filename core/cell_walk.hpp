#pragma once

#include <cmath>
#include <limits>

#include "core/grid_frame.hpp"

namespace cogslam {

/// Visits, in order, every cell that the segment from `from` to `to` passes through, both end cells included.
///
/// Points are in cells: one unit is one cell side, cell (i, j) covers [i, i+1) x [j, j+1). `visit(Cell)` returns false
/// to stop early. Each step crosses one border (Amanatides & Woo 1987); through a corner it steps in x first. The walk
/// ends at the cell of `to` after exactly |dx| + |dy| steps, so rounding can bend it but never make it miss or run on.
template <class Visit>
void walk_cells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visit&& visit) {
  Cell c{static_cast<int>(std::floor(from.x())), static_cast<int>(std::floor(from.y()))};
  const Cell last{static_cast<int>(std::floor(to.x())), static_cast<int>(std::floor(to.y()))};
  const int step_x = last.x >= c.x ? 1 : -1, step_y = last.y >= c.y ? 1 : -1;
  int left_x = std::abs(last.x - c.x), left_y = std::abs(last.y - c.y);

  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double dx = std::abs(to.x() - from.x()), dy = std::abs(to.y() - from.y());
  const double per_x = dx > 0.0 ? 1.0 / dx : kNever, per_y = dy > 0.0 ? 1.0 / dy : kNever;
  // Share of the segment at which the next vertical (x) and horizontal (y) border is crossed.
  double next_x = left_x > 0 ? (step_x > 0 ? c.x + 1 - from.x() : from.x() - c.x) * per_x : kNever;
  double next_y = left_y > 0 ? (step_y > 0 ? c.y + 1 - from.y() : from.y() - c.y) * per_y : kNever;

  if (!visit(c)) return;
  while (left_x + left_y > 0) {
    if (left_y == 0 || (left_x > 0 && next_x <= next_y)) {
      c.x += step_x;
      next_x += per_x;
      --left_x;
    } else {
      c.y += step_y;
      next_y += per_y;
      --left_y;
    }
    if (!visit(c)) return;
  }
}

}  // namespace cogslam
