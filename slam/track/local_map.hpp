#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/pose2.hpp"
#include "slam/track/range_view.hpp"
#include "slam/track/surface_points.hpp"

namespace cogslam {

/// The walls around the robot as the last few key scans saw them: mean point and normal per small cell, so positions
/// are finer than cells. Bounded, and one for the whole filter: it is no particle's map.
class LocalMap {
 public:
  /// Holds the last `keys` scans, one mean point per cell of `cell` [m]; `reach` [m] bounds what `nearest` looks for.
  LocalMap(int keys, double cell, double reach);

  /// Adds a key scan: its surface points and what it saw free, both seen from `T_map_base`. The oldest is dropped when
  /// there are too many.
  void add(const std::vector<SurfacePoint>& points, const RangeView& view, const Pose2& T_map_base);

  /// The nearest point within `radius` <= reach [m] whose normal lies within 60 degrees; null where there is none.
  [[nodiscard]] const SurfacePoint* nearest(const SurfacePoint& point, double radius) const;

  /// Whether a key scan saw through this point.
  [[nodiscard]] bool free_at(const Eigen::Vector2d& point) const;

  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] std::int64_t bytes() const;

 private:
  void average();
  void index();
  [[nodiscard]] int bucket_coordinate(double x) const;

  std::size_t keys_;
  double cell_;
  double reach_;
  struct Key {
    std::vector<SurfacePoint> points;  ///< in the map's frame
    RangeView view;
    Pose2 T_base_map;
  };
  std::deque<Key> scans_;
  std::vector<SurfacePoint> points_;  ///< means, sorted by bucket
  // Buckets of side `reach`, row-major over the bounding box of the points and one bucket around it.
  int left_ = 0, bottom_ = 0, width_ = 0, height_ = 0;
  std::vector<std::uint32_t> first_;  ///< of each bucket in points_, and one past the last
};

}  // namespace cogslam
