#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/grid_frame.hpp"

namespace cogslam {

/// The length of a segment inside the square [x, x+1] x [y, y+1], grown by `margin` on every side (Liang & Barsky);
/// negative where it does not even touch.
inline double length_inside(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Cell c, double margin) {
  const Eigen::Vector2d d = to - from, low(c.x - margin, c.y - margin), high(c.x + 1 + margin, c.y + 1 + margin);
  double enter = 0.0, leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (from[axis] < low[axis] || from[axis] > high[axis]) return -1.0;
      continue;
    }
    const double a = (low[axis] - from[axis]) / d[axis], b = (high[axis] - from[axis]) / d[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter > leave ? -1.0 : (leave - enter) * d.norm();
}

/// Slow twin of walk_cells: tries every cell of the bounding box for one that the segment runs through for longer
/// than `least` cells.
inline std::vector<Cell> touched_cells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double least) {
  const Eigen::Vector2d low = from.cwiseMin(to), high = from.cwiseMax(to);
  std::vector<Cell> out;
  for (int y = static_cast<int>(std::floor(low.y())); y <= static_cast<int>(std::floor(high.y())); ++y) {
    for (int x = static_cast<int>(std::floor(low.x())); x <= static_cast<int>(std::floor(high.x())); ++x) {
      if (length_inside(from, to, {x, y}, 0.0) > least) out.push_back({x, y});
    }
  }
  return out;
}

}  // namespace cogslam
