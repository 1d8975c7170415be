#include "sensors/lidar.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.hpp"

namespace cogslam {
namespace {

Scan blank_scan(const LidarConfig& config) {
  Scan scan;
  scan.angle_first = -0.5 * config.field_of_view;
  scan.angle_increment = config.angle_increment();
  scan.range_min = config.range_min_m;
  scan.range_max = config.range_max_m;
  scan.time_increment = Duration::from_seconds(config.angle_increment() / (2.0 * std::numbers::pi * config.mirror_hz));
  scan.T_base_lidar = config.T_base_lidar;
  return scan;
}

}  // namespace

Lidar::Lidar(const LidarConfig& config, const World& world, std::uint32_t seed)
    : config_(config), caster_(world), seed_(seed), blank_(blank_scan(config)) {
  EXPECTS(config.check().empty());
}

Duration Lidar::sweep_time() const { return (config_.beams - 1) * blank_.time_increment; }

ScanSample Lidar::sweep(const PoseTrack& track, Time start, std::uint64_t index) const {
  ScanSample out{start, blank_};
  out.scan.ranges.reserve(static_cast<std::size_t>(config_.beams));
  Rng rng({seed_, Purpose::kLidarNoise, 0, index});
  for (int beam = 0; beam < config_.beams;) beam = sweep_leg(track, beam, rng, out);
  return out;
}

/// Casts the beams from `beam` on that leave before the next known pose; returns the first that does not. From one
/// beam to the next the origin moves by a constant and the direction turns by a constant (PoseTrack is linear in
/// between), so cosines are needed once per leg.
int Lidar::sweep_leg(const PoseTrack& track, int beam, Rng& rng, ScanSample& out) const {
  const Duration dt = blank_.time_increment;
  const Time begin = out.stamp + beam * dt;
  const auto [from, to] = track.leg_at(begin);
  const double span = static_cast<double>(std::max<std::int64_t>((to.time - from.time).ns, 1));
  const double share = static_cast<double>((begin - from.time).ns) / span;
  const double share_per_beam = static_cast<double>(dt.ns) / span;
  const Pose2 T_map_from = from.T_map_base * config_.T_base_lidar, T_map_to = to.T_map_base * config_.T_base_lidar;
  const Eigen::Vector2d travel = T_map_to.position() - T_map_from.position();
  const double turn = angle_difference(T_map_to.theta, T_map_from.theta);

  Eigen::Vector2d p_map = T_map_from.position() + share * travel;
  const double angle = T_map_from.theta + share * turn + blank_.angle_first + beam * blank_.angle_increment;
  Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  const double turn_per_beam = blank_.angle_increment + share_per_beam * turn;
  const double c = std::cos(turn_per_beam), s = std::sin(turn_per_beam);
  const int last = dt.ns > 0 && to.time > begin ? beam + static_cast<int>((to.time - begin).ns / dt.ns) : beam;
  for (; beam <= last && beam < config_.beams; ++beam) {
    out.scan.ranges.push_back(measure(caster_.cast(p_map, direction, config_.range_max_m), rng));
    p_map += share_per_beam * travel;
    direction = {c * direction.x() - s * direction.y(), s * direction.x() + c * direction.y()};
  }
  return beam;
}

/// What the device says of a true distance [m], or of nothing within range.
float Lidar::measure(std::optional<double> distance, Rng& rng) const {
  // Drawn for every beam, used or not: what one beam meets must not change the noise of the next.
  const double normal = rng.normal();
  const bool lost = rng.uniform() < config_.dropout_probability;
  if (!distance || lost) return Scan::kNoReturn;
  if (*distance < config_.range_min_m) return Scan::kTooClose;

  const bool near = *distance <= config_.near_limit_m;
  const double bound = near ? config_.accuracy_near_m : config_.accuracy_far_m;
  double range = *distance + std::clamp((near ? config_.sigma_near_m : config_.sigma_far_m) * normal, -bound, bound);
  if (config_.resolution_m > 0.0) range = std::round(range / config_.resolution_m) * config_.resolution_m;
  const float reading = static_cast<float>(range);
  if (static_cast<double>(reading) > config_.range_max_m) return Scan::kNoReturn;
  return static_cast<double>(reading) < config_.range_min_m ? Scan::kTooClose : reading;
}

}  // namespace cogslam
