#pragma once

#include <map>
#include <utility>

#include "core/grid.hpp"
#include "slam/map/cell_window.hpp"

namespace cogslam::slow {

/// Slow twin of a map: every cell that was ever written, by its lattice cell.
class LogOddsMap {
 public:
  [[nodiscard]] float at(Cell c) const {
    const auto found = cells_.find({c.x, c.y});
    return found == cells_.end() ? 0.0F : found->second;
  }
  void commit(const Grid<float>& scratch, const CellWindow& changed) {
    const Cell low = scratch.frame().lattice_min;
    for (int y = changed.min.y; y <= changed.max.y; ++y) {
      for (int x = changed.min.x; x <= changed.max.x; ++x) cells_[{x, y}] = scratch[{x - low.x, y - low.y}];
    }
  }

 private:
  std::map<std::pair<int, int>, float> cells_;
};

}  // namespace cogslam::slow
