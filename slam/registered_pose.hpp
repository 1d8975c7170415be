#pragma once

#include <cstddef>

#include "core/pose2.hpp"

namespace cogslam {

/// Where the robot was when a scan was registered.
struct RegisteredPose {
  std::size_t record = 0;  ///< of the log: counts readings from 0, in file order
  Pose2 T_map_base{};
};

}  // namespace cogslam
