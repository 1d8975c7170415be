#include "sensors/reference.hpp"

#include "core/rng.hpp"

namespace cogslam {

ReferenceConfig read_reference_config(ConfigSection& section) {
  ReferenceConfig c;
  section.read("rate_hz", c.rate_hz, {0.0, 1000.0});
  section.read("sigma_min_m", c.sigma_min_m, {0.0, 1.0});
  section.read("sigma_max_m", c.sigma_max_m, {0.0, 1.0});
  section.read_degrees("heading_noise_deg", c.heading_noise, {0.0, 90.0});
  if (c.sigma_min_m > c.sigma_max_m)
    section.fail("sigma_min_m", "sigma_min_m is above sigma_max_m, expected sigma_min_m <= sigma_max_m");
  return c;
}

ReferenceFix Reference::fix(const Pose2& T_map_base, Time stamp, std::uint64_t index) const {
  Rng rng({seed_, Purpose::kReferenceNoise, 0, index});
  const double sigma = rng.uniform(config_.sigma_min_m, config_.sigma_max_m);
  const double dx = sigma * rng.normal(), dy = sigma * rng.normal(), turn = config_.heading_noise * rng.normal();
  return {stamp, {T_map_base.x + dx, T_map_base.y + dy, wrap_angle(T_map_base.theta + turn)}, sigma};
}

}  // namespace cogslam
