#pragma once

#include <algorithm>

#include "core/grid_frame.hpp"

namespace cogslam {

/// A rectangle of lattice cells, both corners included; empty where max < min.
struct CellWindow {
  Cell min{0, 0};
  Cell max{-1, -1};

  [[nodiscard]] bool empty() const { return max.x < min.x || max.y < min.y; }
  [[nodiscard]] int width() const { return std::max(0, max.x - min.x + 1); }
  [[nodiscard]] int height() const { return std::max(0, max.y - min.y + 1); }
  [[nodiscard]] GridFrame frame(double cell_size) const {
    return {.cell_size = cell_size, .lattice_min = min, .width = width(), .height = height()};
  }
  [[nodiscard]] CellWindow grown(int cells) const {
    return {{min.x - cells, min.y - cells}, {max.x + cells, max.y + cells}};
  }
  [[nodiscard]] bool contains(const CellWindow& other) const {
    return other.empty() ||
           (other.min.x >= min.x && other.min.y >= min.y && other.max.x <= max.x && other.max.y <= max.y);
  }
  void include(Cell c) {
    if (empty()) {
      *this = {c, c};
      return;
    }
    min = {std::min(min.x, c.x), std::min(min.y, c.y)};
    max = {std::max(max.x, c.x), std::max(max.y, c.y)};
  }
  bool operator==(const CellWindow&) const = default;
};

/// The cells that both hold.
inline CellWindow intersection(const CellWindow& a, const CellWindow& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

/// The smallest window that holds both.
inline CellWindow hull(CellWindow a, const CellWindow& b) {
  if (!b.empty()) {
    a.include(b.min);
    a.include(b.max);
  }
  return a;
}

/// All cells of a frame, as lattice cells.
inline CellWindow window_of(const GridFrame& frame) {
  return {frame.lattice_min, {frame.lattice_min.x + frame.width - 1, frame.lattice_min.y + frame.height - 1}};
}

}  // namespace cogslam
