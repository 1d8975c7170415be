#pragma once

#include "core/grid.hpp"

namespace cogslam {

/// Where a beam should end, by the belief.
struct ExpectedRange {
  bool known = false;  ///< false: the beam runs into unknown cells before any occupied one
  double enter = 0.0;  ///< range at which it enters the first occupied cell [m]; the far end of the search if none
  double leave = 0.0;  ///< range at which it would leave that cell [m]
};

/// Follows a beam through a log-odds grid from `origin` towards `end` and half as far again beyond it, up to the first
/// occupied cell (log-odds above kOccupiedLogOdds) or the first unknown one (is_unknown, or outside the grid).
/// Points in the map frame [m]. A cell in which the search ends is left at the far end of the search.
ExpectedRange expected_range(const Grid<float>& log_odds, const Eigen::Vector2d& origin, const Eigen::Vector2d& end);

}  // namespace cogslam
