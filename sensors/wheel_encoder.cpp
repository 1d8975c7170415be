#include "sensors/wheel_encoder.hpp"

#include <cmath>
#include <numbers>

namespace cogslam {

WheelEncoderConfig read_wheel_encoder_config(ConfigSection& section) {
  WheelEncoderConfig c;
  section.read("rate_hz", c.rate_hz, {0.0, 1000.0});
  section.read("ticks_per_turn", c.ticks_per_turn, {1, 10000000});
  return c;
}

WheelSample encode_wheels(const WheelEncoderConfig& config, const Truth& truth) {
  const double tick = 2.0 * std::numbers::pi / config.ticks_per_turn;
  WheelSample sample{truth.time, {}};
  for (std::size_t i = 0; i < 4; ++i) sample.angles[i] = tick * std::round(truth.wheel_angles[i] / tick);
  return sample;
}

}  // namespace cogslam
