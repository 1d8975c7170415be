#include "sensors/compass.hpp"

#include <numbers>

#include "core/rng.hpp"
#include "sensors/faults/compass_deflection.hpp"

namespace cogslam {

double heading_of_bearing(double bearing, double declination) {
  return wrap_angle(0.5 * std::numbers::pi - (bearing + declination));
}

double bearing_of_heading(double heading, double declination) {
  const double bearing = wrap_angle(0.5 * std::numbers::pi - heading - declination);
  if (bearing >= 0.0) return bearing;
  const double turned = bearing + 2.0 * std::numbers::pi;
  return turned < 2.0 * std::numbers::pi ? turned : 0.0;  // a tiny negative bearing rounds up to the full turn
}

CompassConfig read_compass_config(ConfigSection& section) {
  CompassConfig c;
  section.read("rate_hz", c.rate_hz, {0.0, 1000.0});
  section.read_degrees("noise_deg", c.noise, {0.0, 90.0});
  section.read_degrees("bias_bound_deg", c.bias_bound, {0.0, 180.0});
  if (section.has("bias_deg")) {
    c.bias = 0.0;
    section.read_degrees("bias_deg", *c.bias, {-180.0, 180.0});
  }
  section.read_degrees("declination_deg", c.declination, {-180.0, 180.0});
  return c;
}

Compass::Compass(const CompassConfig& config, std::uint32_t seed, std::vector<Magnet> magnets)
    : config_(config), seed_(seed), magnets_(std::move(magnets)) {
  Rng rng({seed, Purpose::kCompassBias, 0, 0});
  bias_ = config.bias.value_or(rng.uniform(-config.bias_bound, config.bias_bound));
}

double Compass::bearing(const Pose2& T_map_base, std::uint64_t index) const {
  Rng rng({seed_, Purpose::kCompassNoise, 0, index});
  double heading = T_map_base.theta + bias_ + config_.noise * rng.normal();
  // A bearing counts from the needle, so turning that to the left takes away from the heading.
  if (!magnets_.empty()) heading -= compass_deflection(magnets_, T_map_base.position(), config_.declination);
  return bearing_of_heading(heading, config_.declination);
}

CompassSample Compass::sample(const Pose2& T_map_base, Time stamp, std::uint64_t index) const {
  return {stamp, heading_of_bearing(bearing(T_map_base, index), config_.declination)};
}

}  // namespace cogslam
