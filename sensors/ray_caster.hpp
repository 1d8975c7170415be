#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/grid_frame.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Finds where a ray first meets a surface, in double precision.
///
/// Surfaces lie in the buckets of a uniform grid, and a ray visits its cells in order (Amanatides & Woo 1987) until a
/// hit lies no farther than the cell's far border. Surfaces count from both sides; where two share a corner, no ray
/// slips through between them.
class RayCaster {
 public:
  explicit RayCaster(const std::vector<Segment>& segments);
  /// Of a world: glass lets rays through.
  explicit RayCaster(const World& world) : RayCaster(world.opaque_segments()) {}

  /// Distance [m] from `origin` to the first surface along the unit vector `direction`, nothing if there is none
  /// within `max_range` [m] (itself included). The origin may lie anywhere, on a surface (0) or outside all of them.
  [[nodiscard]] std::optional<double> cast(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                           double max_range) const;

 private:
  void lay_out(const std::vector<Segment>& segments);
  void fill(const std::vector<Segment>& segments);
  [[nodiscard]] bool touches(const Segment& segment, int x, int y) const;
  [[nodiscard]] double nearest_in(std::size_t cell, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                  double nearest) const;

  Rectangle area_;  // all surfaces and a margin [m]
  double cell_size_ = 1.0;
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint32_t> first_;  // of each cell in members_, row-major, one more at the end
  std::vector<Segment> members_;      // copies, cell after cell: one cache line where an index would cost two
};

}  // namespace cogslam
