#pragma once

#include <cstdint>
#include <vector>

#include "core/time.hpp"

namespace cogslam {

/// How evenly and steadily the floor under the camera is lit. Shares of the usual light, 0 switches each off.
struct FloorLightConfig {
  double vignette = 0.25;     ///< lost in the corners of the picture, growing with the distance squared
  double drift = 0.1;         ///< slow change of the light, up to this share either way
  double drift_period = 5.0;  ///< [s] between two independent values of the drift
  double step = 0.0;          ///< sudden changes (a lamp, a shadow), up to this share either way
  double step_period = 4.0;   ///< [s] between two steps
};

/// Light at a moment as a share of the usual, at least 0. A function of (seed, time) alone: drawn in any order.
double light_gain(const FloorLightConfig& config, std::uint32_t seed, Time time);

/// Light at each pixel as a share of that at the centre, row-major.
std::vector<float> vignette_gains(const FloorLightConfig& config, int width, int height);

}  // namespace cogslam
