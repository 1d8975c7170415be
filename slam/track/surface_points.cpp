#include "slam/track/surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cogslam {
namespace {

constexpr int kNeighbours = 3;         // on either side
constexpr double kLineFlatness = 0.2;  // a line is at least five times as long as thick

/// First and second moments of points.
struct Moments {
  double count = 0.0;
  Eigen::Vector2d sum{0.0, 0.0};
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();

  void add(const Eigen::Vector2d& p) {
    count += 1.0;
    sum += p;
    squares += p * p.transpose();
  }
};

/// The normal of the line of least squared distance; nothing where the points do not form one.
std::optional<Eigen::Vector2d> line_normal(const Moments& m) {
  if (m.count < 3.0) return std::nullopt;
  const Eigen::Matrix2d c = m.squares / m.count - m.sum * m.sum.transpose() / (m.count * m.count);
  const double half_trace = 0.5 * (c(0, 0) + c(1, 1)), half_difference = 0.5 * (c(0, 0) - c(1, 1));
  const double root = std::hypot(half_difference, c(0, 1));
  if (half_trace - root > kLineFlatness * kLineFlatness * (half_trace + root)) return std::nullopt;
  const double along = 0.5 * std::atan2(c(0, 1), half_difference);
  return Eigen::Vector2d(-std::sin(along), std::cos(along));
}

}  // namespace

std::vector<SurfacePoint> surface_points(const std::vector<Beam>& sweep, double gap) {
  std::vector<SurfacePoint> points;
  const auto n = static_cast<int>(sweep.size());
  const auto joined = [&](int i, int j) {
    const Beam &a = sweep[static_cast<std::size_t>(i)], &b = sweep[static_cast<std::size_t>(j)];
    return a.hit && b.hit && (a.end - b.end).squaredNorm() < gap * gap;
  };
  for (int i = 0; i < n; ++i) {
    const Beam& beam = sweep[static_cast<std::size_t>(i)];
    if (!beam.hit) continue;
    Moments moments;
    moments.add(beam.end - beam.origin);
    for (const int step : {-1, 1}) {
      for (int k = i + step; k >= 0 && k < n && std::abs(k - i) <= kNeighbours && joined(k, k - step); k += step) {
        moments.add(sweep[static_cast<std::size_t>(k)].end - beam.origin);
      }
    }
    const auto normal = line_normal(moments);
    if (!normal) continue;
    const bool away = normal->dot(beam.origin - beam.end) < 0.0;
    points.push_back({beam.end, away ? Eigen::Vector2d(-*normal) : *normal});
  }
  return points;
}

}  // namespace cogslam
