#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "worlds/world.hpp"

namespace cogslam {

/// Slow twin of RayCaster: solves origin + t direction = a + u (b - a) for every segment and keeps the smallest t.
inline std::optional<double> cast_brute_force(const std::vector<Segment>& segments, const Eigen::Vector2d& origin,
                                              const Eigen::Vector2d& direction, double max_range) {
  std::optional<double> nearest;
  for (const Segment& s : segments) {
    Eigen::Matrix2d m;
    m << direction, s.a - s.b;
    const double determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    if (determinant == 0.0) continue;
    const Eigen::Vector2d r = s.a - origin;
    const double t = (r.x() * m(1, 1) - m(0, 1) * r.y()) / determinant;
    const double u = (m(0, 0) * r.y() - r.x() * m(1, 0)) / determinant;
    if (t < 0.0 || t > max_range || u < 0.0 || u > 1.0) continue;
    if (!nearest || t < *nearest) nearest = t;
  }
  return nearest;
}

}  // namespace cogslam
