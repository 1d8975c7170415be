#include "worlds/glass.hpp"

#include <algorithm>
#include <cmath>

namespace cogslam {
namespace {

constexpr double kAlong = 1e-3;     // [m]
constexpr double kSmallest = 1e-6;  // [m]; shorter pieces are rounding

/// Appends what is left of one surface.
void cut(const Segment& surface, const Segment& pane, std::vector<Segment>& left) {
  const Eigen::Vector2d way = surface.b - surface.a;
  const double length = way.norm();
  const Eigen::Vector2d u = way / length, normal(-u.y(), u.x());
  const double from = u.dot(pane.a - surface.a), to = u.dot(pane.b - surface.a);
  const double first = std::max(0.0, std::min(from, to)), last = std::min(length, std::max(from, to));
  const bool along =
      std::max(std::abs(normal.dot(pane.a - surface.a)), std::abs(normal.dot(pane.b - surface.a))) <= kAlong;
  if (!along || last - first < kSmallest) return left.push_back(surface);
  if (first > kSmallest) left.push_back({surface.a, surface.a + first * u});
  if (length - last > kSmallest) left.push_back({surface.a + last * u, surface.b});
}

}  // namespace

std::vector<Segment> opaque_parts(const std::vector<Segment>& surfaces, const std::vector<Segment>& panes) {
  std::vector<Segment> parts = surfaces;
  for (const Segment& pane : panes) {
    std::vector<Segment> left;
    for (const Segment& surface : parts) cut(surface, pane, left);
    parts = std::move(left);
  }
  return parts;
}

}  // namespace cogslam
