#include "worlds/scattered_boxes.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "worlds/polygon.hpp"

namespace cogslam {
namespace {

constexpr int kTriesPerBox = 200;

struct Box {
  double x, y;           ///< middle [m]
  double heading_deg;    ///< of the width
  double width, length;  ///< [m]
};

constexpr std::array<Box, 7> kShipped{{{-1.20, -1.35, 25.0, 0.6, 0.4},
                                       {0.95, -1.65, -35.0, 0.8, 0.4},
                                       {0.25, -0.15, 40.0, 0.5, 0.5},
                                       {-1.35, 0.60, -15.0, 0.3, 0.8},
                                       {1.25, 1.05, 60.0, 0.5, 0.7},
                                       {-0.35, 1.80, 10.0, 0.7, 0.3},
                                       {1.50, -0.50, 15.0, 0.2, 0.2}}};

bool keeps_clear(const Polygon& candidate, const Polygon& outline, const std::vector<Polygon>& boxes, double lane) {
  if (!inside(outline, candidate.front()) || gap(candidate, outline) < lane) return false;
  const Eigen::Vector2d origin{0.0, 0.0};
  if (inside(candidate, origin)) return false;
  for (const Segment& e : edges(candidate)) {
    if (distance(e, origin) < lane) return false;
  }
  return std::all_of(boxes.begin(), boxes.end(),
                     [&](const Polygon& b) { return !inside(b, candidate.front()) && gap(candidate, b) >= lane; });
}

}  // namespace

double gap(const Polygon& a, const Polygon& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : edges(a)) {
    for (const Segment& t : edges(b)) least = std::min(least, distance(s, t));
  }
  return least;
}

std::vector<Polygon> shipped_boxes(double scale_x, double scale_y) {
  std::vector<Polygon> out;
  for (const Box& b : kShipped) {
    out.push_back(box({scale_x * b.x, scale_y * b.y, radians(b.heading_deg)}, b.width, b.length));
  }
  return out;
}

std::optional<std::vector<Polygon>> drawn_boxes(const Polygon& outline, double lane, Rng& rng) {
  Eigen::Vector2d low = outline.front(), high = outline.front();
  for (const Eigen::Vector2d& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  std::vector<Polygon> boxes;
  const std::size_t wanted = 5 + rng.below(4);
  for (int tries = 0; boxes.size() < wanted; ++tries) {
    if (tries == kTriesPerBox * static_cast<int>(wanted)) return std::nullopt;
    const double x = rng.uniform(low.x(), high.x()), y = rng.uniform(low.y(), high.y());
    const double heading = rng.uniform(-std::numbers::pi, std::numbers::pi);
    const double width = rng.uniform(0.2, 0.8), length = rng.uniform(0.2, 0.8);
    const Polygon candidate = box({x, y, heading}, width, length);
    if (keeps_clear(candidate, outline, boxes, lane)) boxes.push_back(candidate);
  }
  return boxes;
}

}  // namespace cogslam
