#include "worlds/polygon.hpp"

#include <algorithm>

namespace cogslam {
namespace {

/// Loops with less area than this [m^2] bound nothing that a robot or a sensor could meet.
constexpr double kSmallestArea = 1e-6;

bool within_box(const Segment& s, const Eigen::Vector2d& p) {
  return p.x() >= std::min(s.a.x(), s.b.x()) && p.x() <= std::max(s.a.x(), s.b.x()) &&
         p.y() >= std::min(s.a.y(), s.b.y()) && p.y() <= std::max(s.a.y(), s.b.y());
}

/// Whether two edges that share the corner `s.b == t.a` run back over each other.
bool fold(const Segment& s, const Segment& t) { return turn(s.a, s.b, t.b) == 0.0 && (s.a - s.b).dot(t.b - t.a) > 0.0; }

}  // namespace

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

std::vector<Segment> edges(const Polygon& loop) {
  std::vector<Segment> out;
  for (std::size_t i = 0; i < loop.size(); ++i) out.push_back({loop[i], loop[(i + 1) % loop.size()]});
  return out;
}

double signed_area(const Polygon& loop) {
  double twice = 0.0;
  for (const Segment& e : edges(loop)) twice += turn(loop.front(), e.a, e.b);
  return 0.5 * twice;
}

bool inside(const Polygon& loop, const Eigen::Vector2d& p) {
  bool odd = false;
  for (const Segment& e : edges(loop)) {
    if ((e.a.y() > p.y()) == (e.b.y() > p.y())) continue;
    const double x = e.a.x() + (p.y() - e.a.y()) * (e.b.x() - e.a.x()) / (e.b.y() - e.a.y());
    if (p.x() < x) odd = !odd;
  }
  return odd;
}

double distance(const Segment& s, const Eigen::Vector2d& p) {
  const Eigen::Vector2d along = s.b - s.a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - s.a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - s.a - share * along).norm();
}

bool touch(const Segment& s, const Segment& t) {
  const double s_a = turn(t.a, t.b, s.a), s_b = turn(t.a, t.b, s.b);
  const double t_a = turn(s.a, s.b, t.a), t_b = turn(s.a, s.b, t.b);
  if (s_a * s_b < 0.0 && t_a * t_b < 0.0) return true;
  return (s_a == 0.0 && within_box(t, s.a)) || (s_b == 0.0 && within_box(t, s.b)) ||
         (t_a == 0.0 && within_box(s, t.a)) || (t_b == 0.0 && within_box(s, t.b));
}

double distance(const Segment& s, const Segment& t) {
  if (touch(s, t)) return 0.0;
  return std::min({distance(s, t.a), distance(s, t.b), distance(t, s.a), distance(t, s.b)});
}

Polygon box(const Pose2& T_map_box, double width, double length) {
  const double w = 0.5 * width, l = 0.5 * length;
  return {T_map_box * Eigen::Vector2d{-w, -l}, T_map_box * Eigen::Vector2d{w, -l}, T_map_box * Eigen::Vector2d{w, l},
          T_map_box * Eigen::Vector2d{-w, l}};
}

std::optional<std::string> defect(const Polygon& loop) {
  const std::size_t n = loop.size();
  if (n < 3) return "has " + std::to_string(n) + " corners, expected at least 3";
  const std::vector<Segment> all = edges(loop);
  for (std::size_t i = 0; i < n; ++i) {
    if (all[i].a == all[i].b) return "names corner " + std::to_string(i + 1) + " twice in a row";
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool follows = j == i + 1, closes = i == 0 && j + 1 == n;
      const bool crosses = follows ? fold(all[i], all[j]) : closes ? fold(all[j], all[i]) : touch(all[i], all[j]);
      if (crosses) {
        return "crosses itself: the edges from corner " + std::to_string(i + 1) + " and from corner " +
               std::to_string(j + 1) + " meet";
      }
    }
  }
  if (std::abs(signed_area(loop)) < kSmallestArea) return "has no area";
  return std::nullopt;
}

}  // namespace cogslam
