#include "slam/mobile_sensing/stitch.hpp"

#include <algorithm>
#include <cmath>

namespace cogslam {
namespace {

constexpr double kSurest = 0.999;  // a recovered cell can reach 0 or 1, whose log-odds no later evidence could turn

/// The cells of `frame` that the corners of the partial map's rectangle span.
Rectangle span_of(const GridFrame& part, const Pose2& T_map_base) {
  const Eigen::Vector2d low = part.origin(), size = part.cell_size * Eigen::Vector2d(part.width, part.height);
  Rectangle span{T_map_base * low, T_map_base * low};
  for (const Eigen::Vector2d& share : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 1)}) {
    const Eigen::Vector2d corner = T_map_base * Eigen::Vector2d(low + size.cwiseProduct(share));
    span = {span.min.cwiseMin(corner), span.max.cwiseMax(corner)};
  }
  return span;
}

}  // namespace

void stitch(Grid<double>& log_odds, const PartialMap& map, const Pose2& T_map_base) {
  const GridFrame &frame = log_odds.frame(), &part = map.occupancy.frame();
  const Rectangle span = span_of(part, T_map_base);
  const Cell low = frame.cell_of(span.min), high = frame.cell_of(span.max);
  const Pose2 T_base_map = T_map_base.inverse();
  for (int y = std::max(low.y, 0); y <= std::min(high.y, frame.height - 1); ++y) {
    for (int x = std::max(low.x, 0); x <= std::min(high.x, frame.width - 1); ++x) {
      const Cell source = part.cell_of(T_base_map * frame.centre_of({x, y}));
      if (!part.contains(source) || map.weight[source] <= 0.0) continue;
      const double p = std::clamp(map.occupancy[source], 1.0 - kSurest, kSurest);
      log_odds[{x, y}] += std::log(p / (1.0 - p));
    }
  }
}

}  // namespace cogslam
