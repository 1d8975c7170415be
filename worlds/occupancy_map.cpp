#include "worlds/occupancy_map.hpp"

#include <cmath>
#include <utility>

#include "core/check.hpp"

namespace cogslam {

std::optional<GridFrame> OccupancyMap::frame() const {
  constexpr double kSame = 1e-6;  // [cells]
  const double x = T_map_image.x / resolution, y = T_map_image.y / resolution;
  if (T_map_image.theta != 0.0 || std::abs(x - std::round(x)) > kSame || std::abs(y - std::round(y)) > kSame) {
    return std::nullopt;
  }
  return GridFrame{.cell_size = resolution,
                   .lattice_min = {static_cast<int>(std::round(x)), static_cast<int>(std::round(y))},
                   .width = width,
                   .height = height};
}

Cell OccupancyMap::cell_of(const Eigen::Vector2d& p_map) const {
  if (const auto on_lattice = frame()) return on_lattice->cell_of(p_map);
  const Eigen::Vector2d p = T_map_image.inverse() * p_map / resolution;
  return {static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
}

Eigen::Vector2d OccupancyMap::point(const Eigen::Vector2d& p_image_cells) const {
  if (const auto on_lattice = frame()) {
    return {(p_image_cells.x() + on_lattice->lattice_min.x) * resolution,
            (p_image_cells.y() + on_lattice->lattice_min.y) * resolution};
  }
  return T_map_image * Eigen::Vector2d(p_image_cells * resolution);
}

OccupancyMap map_on(const GridFrame& frame, std::vector<MapCell> cells) {
  EXPECTS(cells.size() == frame.size());
  return {.width = frame.width,
          .height = frame.height,
          .resolution = frame.cell_size,
          .T_map_image = {frame.origin().x(), frame.origin().y(), 0.0},
          .cells = std::move(cells)};
}

}  // namespace cogslam
