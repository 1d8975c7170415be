#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

namespace cogslam {

/// A cell of a grid: column x (to the right), row y (upwards), from the lower-left corner.
struct Cell {
  int x = 0;
  int y = 0;

  bool operator==(const Cell&) const = default;
};

/// An axis-aligned rectangle in the plane [m].
struct Rectangle {
  Eigen::Vector2d min{0.0, 0.0};
  Eigen::Vector2d max{0.0, 0.0};

  [[nodiscard]] bool contains(const Eigen::Vector2d& p) const {
    return p.x() >= min.x() && p.x() <= max.x() && p.y() >= min.y() && p.y() <= max.y();
  }
};

/// Where a grid lies and how its cells are numbered; it holds no values.
///
/// Every grid of a cell size lies on one lattice: cell borders are the whole multiples of `cell_size`, so grids of
/// different extent overlay exactly. Cell (0, 0) of the frame is lattice cell `lattice_min`. Cells have centres, and
/// `cell_of(centre_of(c)) == c` for every cell. Row-major: index = y * width + x (the paper's l = i c + j).
struct GridFrame {
  double cell_size = 0.1;  ///< [m]
  Cell lattice_min{};      ///< lattice cell of the lower-left cell
  int width = 0;           ///< cells along x
  int height = 0;          ///< cells along y

  /// The smallest frame whose cells cover `area`, grown by `margin_cells` on every side.
  static GridFrame covering(const Rectangle& area, double cell_size, int margin_cells = 0);

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  [[nodiscard]] bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  [[nodiscard]] std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x);
  }

  /// The cell that holds a point of the map [m]; it need not lie inside the frame.
  [[nodiscard]] Cell cell_of(const Eigen::Vector2d& p_map) const {
    return {static_cast<int>(std::floor(p_map.x() / cell_size)) - lattice_min.x,
            static_cast<int>(std::floor(p_map.y() / cell_size)) - lattice_min.y};
  }
  [[nodiscard]] Eigen::Vector2d centre_of(Cell c) const {
    return {(c.x + lattice_min.x + 0.5) * cell_size, (c.y + lattice_min.y + 0.5) * cell_size};
  }
  /// Lower-left corner of the frame [m].
  [[nodiscard]] Eigen::Vector2d origin() const { return {lattice_min.x * cell_size, lattice_min.y * cell_size}; }

  bool operator==(const GridFrame&) const = default;
};

}  // namespace cogslam
