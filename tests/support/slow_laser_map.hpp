#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "slam/mobile_sensing/laser_map.hpp"

namespace cogslam::slow {

/// p(m | z) at one point of the lidar's frame: every beam and every piece of surface is asked.
inline double occupancy_at(const LaserModel& model, const Scan& scan, const Eigen::Vector2d& p) {
  const double limit = std::min(scan.range_max, model.range_max_m);
  const auto direction = [&](std::size_t i) {
    const double a = scan.angle_first + static_cast<double>(i) * scan.angle_increment;
    return Eigen::Vector2d(std::cos(a), std::sin(a));
  };
  const auto ends = [&](std::size_t i) { return std::isfinite(scan.ranges[i]) && scan.ranges[i] <= limit; };
  const auto end = [&](std::size_t i) -> Eigen::Vector2d { return direction(i) * scan.ranges[i]; };
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  const std::size_t n = scan.ranges.size();
  const auto joined = [&](std::size_t i) {
    if (!ends(i) || !ends(i + 1)) return false;
    // The sine of the angle between the piece and the longer of the two beams.
    const Eigen::Vector2d piece = end(i + 1) - end(i);
    const Eigen::Vector2d beam = scan.ranges[i] > scan.ranges[i + 1] ? direction(i) : direction(i + 1);
    return std::abs(cross(piece.normalized(), beam)) >= std::sin(model.least_incidence);
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    if (ends(i)) nearest = std::min(nearest, (p - end(i)).norm());
    if (i + 1 == n || !joined(i)) continue;
    for (int k = 0; k <= 2000; ++k)
      nearest = std::min(nearest, (p - end(i) - k / 2000.0 * (end(i + 1) - end(i))).norm());
  }
  std::size_t beam = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (direction(i).dot(p) > direction(beam).dot(p)) beam = i;
  }
  bool free = std::abs(cross(direction(beam), p.normalized())) <= std::sin(0.5 * scan.angle_increment) &&
              direction(beam).dot(p) > 0.0 && p.norm() <= limit;
  const std::size_t other = cross(direction(beam), p) >= 0.0 ? beam + 1 : beam - 1;  // wraps below 0: beyond n
  if (free && other < n && joined(std::min(beam, other))) {
    free = cross(end(std::max(beam, other)) - end(std::min(beam, other)), p - end(std::min(beam, other))) >= 0.0;
  } else if (free) {
    const bool open = scan.ranges[beam] == Scan::kNoReturn || scan.ranges[beam] > limit;
    free = open || (std::isfinite(scan.ranges[beam]) && p.norm() <= scan.ranges[beam]);
  }
  const double base = free ? model.p_free : kUnchanged;
  return base + (model.p_occupied - base) * std::exp(-0.5 * nearest * nearest / (model.sigma_m * model.sigma_m));
}

}  // namespace cogslam::slow
