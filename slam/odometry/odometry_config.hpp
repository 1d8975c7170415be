#pragma once

#include <cstdint>

#include "core/config.hpp"
#include "slam/odometry/visual_odometry.hpp"
#include "slam/odometry/wheel_odometry.hpp"

namespace cogslam {

enum class OdometrySource : std::uint8_t {
  kVisual,  ///< floor camera, and wheels where it sees nothing
  kWheel,   ///< wheels only, whatever the camera sees
};

struct OdometryConfig {
  OdometrySource source = OdometrySource::kVisual;
  VisualOdometryConfig visual{};
  WheelOdometryConfig wheel{};
};

/// Reads the `odometry:` section.
void read(ConfigSection& section, OdometryConfig& config);

}  // namespace cogslam
