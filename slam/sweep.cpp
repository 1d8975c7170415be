#include "slam/sweep.hpp"

#include <algorithm>
#include <cmath>

namespace cogslam {
namespace {

/// How far the beam goes and whether something stands there; false: it says nothing.
bool interpret(float range, const Scan& scan, const SweepConfig& config, Beam& beam) {
  if (std::isnan(range) || range == Scan::kTooClose) return false;
  if (range == Scan::kNoReturn) {
    if (!config.carve_no_return) return false;
    beam.range = static_cast<float>(std::min(scan.range_max, config.max_free_range));
    return true;
  }
  beam.hit = range <= config.max_hit_range;
  beam.range = beam.hit ? range : static_cast<float>(std::min<double>(range, config.max_free_range));
  return true;
}

}  // namespace

std::vector<Beam> sweep_of(const Reading& reading, const SweepConfig& config) {
  std::vector<Beam> beams;
  if (!reading.scan) return beams;
  const Scan& scan = *reading.scan;
  const std::size_t all = scan.ranges.size(), used = std::min(all, static_cast<std::size_t>(config.beams));
  beams.reserve(used);
  for (std::size_t k = 0; k < used; ++k) {
    const std::size_t i = (2 * k + 1) * all / (2 * used);
    Beam beam;
    if (!interpret(scan.ranges[i], scan, config, beam)) continue;
    const double since_stamp = static_cast<double>(i) * scan.time_increment.seconds();
    const Pose2 T_base_lidar = Pose2::exp(since_stamp * reading.twist) * scan.T_base_lidar;
    const double angle = scan.angle_first + static_cast<double>(i) * scan.angle_increment;
    beam.origin = T_base_lidar.position();
    beam.end = T_base_lidar * Eigen::Vector2d(beam.range * std::cos(angle), beam.range * std::sin(angle));
    beams.push_back(beam);
  }
  return beams;
}

}  // namespace cogslam
