#pragma once

#include <string>
#include <vector>

#include "core/grid.hpp"

namespace cogslam {

/// A log-odds grid drawn with one letter per cell, top row first: '#' occupied (2), '.' free (-2), ' ' unknown (0).
inline Grid<float> drawn_grid(const std::vector<std::string>& rows, double cell_size, Cell lattice_min = {}) {
  const int width = static_cast<int>(rows.front().size()), height = static_cast<int>(rows.size());
  Grid<float> grid(GridFrame{.cell_size = cell_size, .lattice_min = lattice_min, .width = width, .height = height});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const char letter = rows[static_cast<std::size_t>(height - 1 - y)][static_cast<std::size_t>(x)];
      grid[{x, y}] = letter == '#' ? 2.0F : letter == '.' ? -2.0F : 0.0F;
    }
  }
  return grid;
}

/// The drawing of a grid: above 0 '#', below 0 '.', 0 ' '.
inline std::vector<std::string> drawing_of(const Grid<float>& grid) {
  std::vector<std::string> rows;
  for (int y = grid.frame().height - 1; y >= 0; --y) {
    rows.emplace_back();
    for (int x = 0; x < grid.frame().width; ++x) {
      const float value = grid[{x, y}];
      rows.back() += value > 0.0F ? '#' : value < 0.0F ? '.' : ' ';
    }
  }
  return rows;
}

}  // namespace cogslam
