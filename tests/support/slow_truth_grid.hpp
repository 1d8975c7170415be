#pragma once

#include <algorithm>

#include "worlds/polygon.hpp"
#include "worlds/truth_grid.hpp"

namespace cogslam {

/// Whether a segment shares a point with a closed rectangle (Liang & Barsky 1984).
inline bool meets(const Segment& s, const Rectangle& r) {
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = s.a[axis], step = s.b[axis] - s.a[axis];
    if (step == 0.0) {
      if (from < r.min[axis] || from > r.max[axis]) return false;
      continue;
    }
    const double one = (r.min[axis] - from) / step, other = (r.max[axis] - from) / step;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  }
  return first <= last;
}

/// What a cell may be called; more than one answer only where a surface comes within `slack` of its border.
struct PossibleTruth {
  bool may_be_occupied = false;
  bool must_be_occupied = false;
  TruthCell otherwise = TruthCell::kUnobservable;

  [[nodiscard]] bool allows(TruthCell cell) const {
    if (cell == TruthCell::kOccupied) return may_be_occupied;
    return !must_be_occupied && cell == otherwise;
  }
};

/// The truth of one cell of a room with one outer wall and boxes that do not overlap: every surface is clipped against
/// the cell, and its centre is free if an odd number of walls and no box goes round it.
inline PossibleTruth slow_truth(const World& world, const Rectangle& cell, double slack = 1e-9) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(slack);
  PossibleTruth out;
  for (const Segment& s : world.segments()) {
    out.may_be_occupied = out.may_be_occupied || meets(s, {cell.min - margin, cell.max + margin});
    out.must_be_occupied = out.must_be_occupied || meets(s, {cell.min + margin, cell.max - margin});
  }
  const Eigen::Vector2d centre = 0.5 * (cell.min + cell.max);
  bool is_free = inside(world.walls.front(), centre);
  for (const Polygon& box : world.obstacles) is_free = is_free && !inside(box, centre);
  if (is_free) out.otherwise = TruthCell::kFree;
  return out;
}

}  // namespace cogslam
