#include "sensors/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// A surface also lies in the cells that it misses by this much [m], so that rounding on the way of a ray, which is
// about 1e-14 m, can lead it through a neighbour but never past a surface.
constexpr double kMargin = 1e-9;
// More cells mean fewer surfaces in each and more cells on the way. For 4 to 1600 surfaces a sweep takes the same
// within 10 % for 0.25 to 2 (bench/lidar.cpp); many more cells cost up to twice as much.
constexpr double kCellsPerSegment = 1.0;
constexpr int kMaxCellsPerSide = 1024;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The shares [m] of a ray, along one axis, that lie between two borders.
struct Span {
  double begin;
  double end;
};

Span between(double origin, double direction, double min, double max) {
  if (direction == 0.0) return origin >= min && origin <= max ? Span{-kNever, kNever} : Span{kNever, -kNever};
  const double a = (min - origin) / direction, b = (max - origin) / direction;
  return {std::min(a, b), std::max(a, b)};
}

/// How a ray crosses the borders of one axis.
struct Axis {
  int cell;
  int step;
  double next;  // distance along the ray to the next border
  double per;   // and from one border to the next
};

Axis start_axis(double origin, double direction, double entry, double min, double cell_size, int cells) {
  const double place = (origin + entry * direction - min) / cell_size;
  const int cell = std::clamp(static_cast<int>(std::floor(place)), 0, cells - 1);
  if (direction == 0.0) return {cell, 0, kNever, kNever};
  const int step = direction > 0.0 ? 1 : -1;
  const double border = min + (step > 0 ? cell + 1 : cell) * cell_size;
  return {cell, step, (border - origin) / direction, cell_size / std::abs(direction)};
}

}  // namespace

RayCaster::RayCaster(const std::vector<Segment>& segments) {
  if (segments.empty()) return;
  lay_out(segments);
  fill(segments);
}

void RayCaster::lay_out(const std::vector<Segment>& segments) {
  area_ = {segments[0].a, segments[0].a};
  for (const Segment& s : segments) {
    area_.min = area_.min.cwiseMin(s.a).cwiseMin(s.b);
    area_.max = area_.max.cwiseMax(s.a).cwiseMax(s.b);
  }
  EXPECTS(area_.min.allFinite() && area_.max.allFinite());
  const double pad = 1e-6 + 1e-6 * (area_.max - area_.min).maxCoeff();
  area_.min.array() -= pad;
  area_.max.array() += pad;
  const Eigen::Vector2d size = area_.max - area_.min;
  cell_size_ = std::sqrt(size.x() * size.y() / (kCellsPerSegment * static_cast<double>(segments.size())));
  cell_size_ = std::max(cell_size_, size.maxCoeff() / kMaxCellsPerSide);
  width_ = std::max(1, static_cast<int>(std::ceil(size.x() / cell_size_)));
  height_ = std::max(1, static_cast<int>(std::ceil(size.y() / cell_size_)));
}

void RayCaster::fill(const std::vector<Segment>& segments) {
  std::vector<std::vector<Segment>> buckets(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  const auto column = [&](double x) {
    return std::clamp(static_cast<int>(std::floor((x - area_.min.x()) / cell_size_)), 0, width_ - 1);
  };
  const auto row = [&](double y) {
    return std::clamp(static_cast<int>(std::floor((y - area_.min.y()) / cell_size_)), 0, height_ - 1);
  };
  for (const Segment& s : segments) {
    const Eigen::Vector2d low = s.a.cwiseMin(s.b), high = s.a.cwiseMax(s.b);
    for (int y = row(low.y() - kMargin); y <= row(high.y() + kMargin); ++y)
      for (int x = column(low.x() - kMargin); x <= column(high.x() + kMargin); ++x)
        if (touches(s, x, y)) buckets[static_cast<std::size_t>(y * width_ + x)].push_back(s);
  }
  first_.push_back(0);
  for (const auto& bucket : buckets) {
    members_.insert(members_.end(), bucket.begin(), bucket.end());
    first_.push_back(static_cast<std::uint32_t>(members_.size()));
  }
}

/// Whether the segment's line passes within kMargin of the cell; its bounding box is known to.
bool RayCaster::touches(const Segment& segment, int x, int y) const {
  const Eigen::Vector2d along = segment.b - segment.a;
  const Eigen::Vector2d centre = area_.min + cell_size_ * Eigen::Vector2d(x + 0.5, y + 0.5);
  const double half = 0.5 * cell_size_ + kMargin;
  return std::abs(cross(along, centre - segment.a)) <= half * along.lpNorm<1>() + kMargin * along.norm();
}

double RayCaster::nearest_in(std::size_t cell, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                             double nearest) const {
  for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
    const Eigen::Vector2d a = members_[i].a - origin, b = members_[i].b - origin;
    // Side of the ray on which each end lies. Neighbours compute the very same number at their common corner: no gap.
    const double side_a = cross(direction, a), side_b = cross(direction, b);
    if ((side_a > 0.0 && side_b > 0.0) || (side_a < 0.0 && side_b < 0.0)) continue;
    const double at_a = direction.dot(a), at_b = direction.dot(b);
    if (side_a == side_b) {  // the segment lies along the ray
      if (at_a >= 0.0 || at_b >= 0.0) nearest = std::min(nearest, std::max(0.0, std::min(at_a, at_b)));
      continue;
    }
    const double distance = at_a + (at_b - at_a) * (side_a / (side_a - side_b));
    if (distance >= 0.0 && distance < nearest) nearest = distance;
  }
  return nearest;
}

std::optional<double> RayCaster::cast(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                      double max_range) const {
  if (members_.empty()) return std::nullopt;
  const Span in_x = between(origin.x(), direction.x(), area_.min.x(), area_.max.x());
  const Span in_y = between(origin.y(), direction.y(), area_.min.y(), area_.max.y());
  const double entry = std::max({0.0, in_x.begin, in_y.begin});
  const double end = std::min({max_range, in_x.end, in_y.end});
  if (entry > end) return std::nullopt;

  Axis x = start_axis(origin.x(), direction.x(), entry, area_.min.x(), cell_size_, width_);
  Axis y = start_axis(origin.y(), direction.y(), entry, area_.min.y(), cell_size_, height_);
  double nearest = kNever;
  while (true) {
    nearest = nearest_in(static_cast<std::size_t>(y.cell * width_ + x.cell), origin, direction, nearest);
    const double border = std::min(x.next, y.next);
    if (nearest <= border || border > end) break;
    Axis& axis = x.next <= y.next ? x : y;
    axis.cell += axis.step;
    axis.next += axis.per;
    if (axis.cell < 0 || axis.cell >= (&axis == &x ? width_ : height_)) break;
  }
  return nearest <= max_range ? std::optional(nearest) : std::nullopt;
}

}  // namespace cogslam
