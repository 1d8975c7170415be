#pragma once

#include "core/config.hpp"
#include "sensors/readings.hpp"
#include "sim/truth.hpp"

namespace cogslam {

struct WheelEncoderConfig {
  double rate_hz = 50.0;      ///< 0: no encoders
  int ticks_per_turn = 1024;  ///< of the wheel, gear included
};

WheelEncoderConfig read_wheel_encoder_config(ConfigSection& section);

/// The angles of the wheels as incremental encoders count them: whole ticks since the start, nothing else is wrong. The
/// first edge lies half a tick from the start, so a wheel at rest does not flicker.
WheelSample encode_wheels(const WheelEncoderConfig& config, const Truth& truth);

}  // namespace cogslam
