#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/grid_frame.hpp"
#include "core/pose2.hpp"

namespace cogslam {

enum class MapCell : std::uint8_t { kFree, kOccupied, kUnknown };

/// A map as others store it: an image of cells, laid anywhere into the plane.
struct OccupancyMap {
  int width = 0;               ///< cells along the image's x
  int height = 0;              ///< cells along the image's y
  double resolution = 0.1;     ///< side of a cell [m]
  Pose2 T_map_image{};         ///< lower-left corner of the lower-left cell; x to the right, y up in the image
  std::vector<MapCell> cells;  ///< row-major, the lowest row first

  /// Cells beyond the image are unknown.
  [[nodiscard]] MapCell at(Cell c) const {
    if (c.x < 0 || c.y < 0 || c.x >= width || c.y >= height) return MapCell::kUnknown;
    return cells[static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x)];
  }
  /// The cell that holds a point of the plane [m]; it may lie beyond the image.
  [[nodiscard]] Cell cell_of(const Eigen::Vector2d& p_map) const;
  /// A point of the plane [m] from coordinates of the image [cells]. Where the map lies on the lattice of GridFrame,
  /// the very numbers that GridFrame gives.
  [[nodiscard]] Eigen::Vector2d point(const Eigen::Vector2d& p_image_cells) const;
  /// The same cells as a frame, where they lie on its lattice: not turned, origin a whole multiple of the resolution
  /// within a millionth of a cell.
  [[nodiscard]] std::optional<GridFrame> frame() const;

  bool operator==(const OccupancyMap&) const = default;
};

/// A map on the lattice; `cells` in the order of the frame.
OccupancyMap map_on(const GridFrame& frame, std::vector<MapCell> cells);

}  // namespace cogslam
