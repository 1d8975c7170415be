#pragma once

#include <cmath>
#include <cstdint>

#include "core/pose2.hpp"
#include "sensors/floor_camera.hpp"

namespace cogslam {

/// A camera without any noise, vignette or change of light.
inline FloorCameraConfig clean_camera() {
  FloorCameraConfig config;
  config.noise = 0.0;
  config.light = {.vignette = 0.0, .drift = 0.0, .step = 0.0};
  return config;
}

inline Time frame_stamp(std::uint64_t frame) { return {static_cast<std::int64_t>(frame) * 33'333'333}; }

inline double grey_mean(const FloorImage& image) {
  double sum = 0.0;
  for (const std::uint8_t grey : image.grey) sum += grey;
  return sum / static_cast<double>(image.grey.size());
}

inline double grey_deviation(const FloorImage& image) {
  const double mean = grey_mean(image);
  double sum = 0.0;
  for (const std::uint8_t grey : image.grey) sum += (grey - mean) * (grey - mean);
  return std::sqrt(sum / static_cast<double>(image.grey.size()));
}

}  // namespace cogslam
