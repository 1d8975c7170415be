#include "slam/map/expected_range.hpp"

#include <algorithm>

#include "core/cell_walk.hpp"
#include "slam/map/log_odds.hpp"

namespace cogslam {
namespace {

struct Span {
  double enter;
  double leave;
};

/// Shares of the line `from` + t (`to` - `from`) that lie inside a cell (slab test); all in cells.
Span span_in(Cell c, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Span span{0.0, 1.0};
  for (int axis = 0; axis < 2; ++axis) {
    const double low = axis == 0 ? c.x : c.y, step = to[axis] - from[axis];
    if (step == 0.0) continue;
    const double a = (low - from[axis]) / step, b = (low + 1.0 - from[axis]) / step;
    span.enter = std::max(span.enter, std::min(a, b));
    span.leave = std::min(span.leave, std::max(a, b));
  }
  return span;
}

}  // namespace

ExpectedRange expected_range(const Grid<float>& log_odds, const Eigen::Vector2d& origin, const Eigen::Vector2d& end) {
  const GridFrame& frame = log_odds.frame();
  const Eigen::Vector2d from = origin / frame.cell_size;
  const Eigen::Vector2d to = (origin + 1.5 * (end - origin)) / frame.cell_size;
  const double length = 1.5 * (end - origin).norm();

  ExpectedRange result{.known = true, .enter = length, .leave = length};
  walk_cells(from, to, [&](Cell lattice_cell) {
    const Cell c{lattice_cell.x - frame.lattice_min.x, lattice_cell.y - frame.lattice_min.y};
    if (!frame.contains(c) || is_unknown(log_odds[c])) {
      result.known = false;
      return false;
    }
    if (log_odds[c] <= kOccupiedLogOdds) return true;
    const Span span = span_in(lattice_cell, from, to);
    result.enter = span.enter * length;
    result.leave = span.leave * length;
    return false;
  });
  return result;
}

}  // namespace cogslam
