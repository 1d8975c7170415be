#include "slam/track/range_view.hpp"

#include <algorithm>
#include <cmath>

namespace cogslam {
namespace {

constexpr double kWidestGap = 0.05;  // rad between neighbouring rays: nothing is known in wider gaps

}  // namespace

RangeView::RangeView(const std::vector<Beam>& sweep) {
  if (sweep.empty()) return;
  origin_ = sweep[sweep.size() / 2].origin;
  for (const Beam& beam : sweep) {
    const Eigen::Vector2d reach = beam.end - origin_;
    rays_.push_back({std::atan2(reach.y(), reach.x()), reach.norm()});
  }
  std::sort(rays_.begin(), rays_.end(), [](const Ray& a, const Ray& b) { return a.bearing < b.bearing; });
}

bool RangeView::passes(const Eigen::Vector2d& point, double margin) const {
  const Eigen::Vector2d reach = point - origin_;
  const double bearing = std::atan2(reach.y(), reach.x());
  const auto after =
      std::lower_bound(rays_.begin(), rays_.end(), bearing, [](const Ray& ray, double b) { return ray.bearing < b; });
  if (after == rays_.begin() || after == rays_.end()) return false;
  const auto before = after - 1;
  const double least = std::min(before->range, after->range);  // both must have passed, or it may stand between them
  return after->bearing - before->bearing < kWidestGap && reach.norm() + margin < least;
}

}  // namespace cogslam
