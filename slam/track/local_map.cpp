#include "slam/track/local_map.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kFarthestKey = 200.0;  // m: from beyond a scan says nothing here, and the index would grow
constexpr double kFreeMargin = 0.3;     // m: so far before the end of a beam all is free
constexpr double kSameSide = 0.5;       // cos 60 deg: the other side of a thin wall is another surface

struct Keyed {
  std::int32_t y, x;
  std::uint32_t index;
  bool operator<(const Keyed& other) const { return std::tie(y, x, index) < std::tie(other.y, other.x, other.index); }
};

/// Indices of the points, cell by cell of a lattice; within a cell in their own order.
std::vector<Keyed> by_cell(const std::vector<SurfacePoint>& points, double cell) {
  std::vector<Keyed> keys;
  keys.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    keys.push_back({static_cast<std::int32_t>(std::floor(points[i].position.y() / cell)),
                    static_cast<std::int32_t>(std::floor(points[i].position.x() / cell)),
                    static_cast<std::uint32_t>(i)});
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

LocalMap::LocalMap(int keys, double cell, double reach)
    : keys_(static_cast<std::size_t>(keys)), cell_(cell), reach_(reach) {
  EXPECTS(keys > 0 && cell > 0.0 && reach > 0.0);
}

void LocalMap::add(const std::vector<SurfacePoint>& points, const RangeView& view, const Pose2& T_map_base) {
  Key key{points, view, T_map_base.inverse()};
  for (SurfacePoint& point : key.points) {
    point.normal = Pose2{0.0, 0.0, T_map_base.theta} * point.normal;
    point.position = T_map_base * point.position;
  }
  scans_.push_back(std::move(key));
  const auto too_far = [&](const Key& old) { return (old.T_base_map * T_map_base.position()).norm() > kFarthestKey; };
  std::erase_if(scans_, too_far);
  if (scans_.size() > keys_) scans_.pop_front();
  average();
  index();
}

/// One mean point per cell and side of a wall.
void LocalMap::average() {
  std::vector<SurfacePoint> all;
  for (const Key& key : scans_) all.insert(all.end(), key.points.begin(), key.points.end());
  points_.clear();
  const std::vector<Keyed> keys = by_cell(all, cell_);
  for (std::size_t i = 0, last = 0; i < keys.size(); i = last) {
    for (last = i; last < keys.size() && keys[last].x == keys[i].x && keys[last].y == keys[i].y;) ++last;
    const Eigen::Vector2d front = all[keys[i].index].normal;
    SurfacePoint sides[2];
    double counts[2] = {0.0, 0.0};
    for (std::size_t k = i; k < last; ++k) {
      const SurfacePoint& p = all[keys[k].index];
      const int side = p.normal.dot(front) > 0.0 ? 0 : 1;
      sides[side].position += p.position;
      sides[side].normal += p.normal;
      counts[side] += 1.0;
    }
    for (int side = 0; side < 2; ++side) {
      if (counts[side] == 0.0 || sides[side].normal.norm() < 1e-6) continue;
      points_.push_back({sides[side].position / counts[side], sides[side].normal.normalized()});
    }
  }
}

int LocalMap::bucket_coordinate(double x) const { return static_cast<int>(std::floor(x / reach_)); }

void LocalMap::index() {
  if (points_.empty()) return;
  const std::vector<Keyed> keys = by_cell(points_, reach_);
  std::vector<SurfacePoint> sorted;
  sorted.reserve(points_.size());
  int right = keys[0].x;
  left_ = keys[0].x;
  for (const Keyed& key : keys) {
    left_ = std::min(left_, key.x);
    right = std::max(right, key.x);
    sorted.push_back(points_[key.index]);
  }
  points_ = std::move(sorted);
  left_ -= 1;
  bottom_ = keys.front().y - 1;
  width_ = right - left_ + 2;
  height_ = keys.back().y - bottom_ + 2;
  first_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) + 1, 0);
  const auto bucket = [&](const Keyed& key) {
    return static_cast<std::size_t>(key.y - bottom_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(key.x - left_);
  };
  for (const Keyed& key : keys) ++first_[bucket(key) + 1];
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
}

const SurfacePoint* LocalMap::nearest(const SurfacePoint& point, double radius) const {
  const int x = bucket_coordinate(point.position.x()) - left_, y = bucket_coordinate(point.position.y()) - bottom_;
  const SurfacePoint* best = nullptr;
  double best_d2 = radius * radius;
  for (int row = std::max(0, y - 1); row <= std::min(height_ - 1, y + 1); ++row) {
    const int from = std::max(0, x - 1), to = std::min(width_ - 1, x + 1);
    if (from > to) continue;
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    const std::uint32_t end = first_[start + static_cast<std::size_t>(to) + 1];
    for (std::uint32_t i = first_[start + static_cast<std::size_t>(from)]; i < end; ++i) {
      const double d2 = (points_[i].position - point.position).squaredNorm();
      if (d2 < best_d2 && points_[i].normal.dot(point.normal) > kSameSide) {
        best = &points_[i];
        best_d2 = d2;
      }
    }
  }
  return best;
}

bool LocalMap::free_at(const Eigen::Vector2d& point) const {
  return std::any_of(scans_.begin(), scans_.end(),
                     [&](const Key& key) { return key.view.passes(key.T_base_map * point, kFreeMargin); });
}

std::int64_t LocalMap::bytes() const {
  std::size_t points = points_.capacity();
  for (const Key& key : scans_) points += key.points.capacity();
  return static_cast<std::int64_t>(points * sizeof(SurfacePoint) + first_.capacity() * sizeof(first_[0]));
}

}  // namespace cogslam
