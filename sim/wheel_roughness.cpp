#include "sim/wheel_roughness.hpp"

#include <algorithm>
#include <cmath>

#include "core/rng.hpp"

namespace cogslam {
namespace {

// Simulation steps count from 1, so tick 0 is free for the state at the start.
constexpr std::uint64_t kStart = 0;

Rng draws(std::uint32_t seed, std::size_t wheel, std::uint64_t tick) {
  return Rng(
      {.seed = seed, .purpose = Purpose::kWheelRoughness, .entity = static_cast<std::uint32_t>(wheel), .tick = tick});
}

}  // namespace

WheelRoughness::WheelRoughness(const RoughnessConfig& config, std::uint32_t seed) : config_(config), seed_(seed) {
  for (std::size_t i = 0; i < 4; ++i) {
    Rng rng = draws(seed_, i, kStart);
    rolling_[i] = rng.normal();
    grip_[i] = rng.normal();
  }
}

void WheelRoughness::roll(const WheelValues& way, std::uint64_t tick) {
  if (config_.rolling == 0.0 && config_.grip == 0.0) return;
  for (std::size_t i = 0; i < 4; ++i) {
    Rng rng = draws(seed_, i, tick);
    const double kept = std::exp(-way[i] / config_.length);
    const double fresh = std::sqrt(1.0 - kept * kept);
    rolling_[i] = kept * rolling_[i] + fresh * rng.normal();
    grip_[i] = kept * grip_[i] + fresh * rng.normal();
  }
}

double WheelRoughness::grip_factor(std::size_t i) const { return std::max(0.0, 1.0 + config_.grip * grip_[i]); }

}  // namespace cogslam
