#pragma once

#include <vector>

#include "sensors/faults/outlier_beams.hpp"
#include "sensors/faults/stream_fault.hpp"

namespace cogslam {

/// All that is wrong with the sensors. What misleads them from outside (glass, magnets) belongs to the world.
struct SensorFaults {
  std::vector<StreamFault> streams;
  std::vector<OutlierBeams> outliers;
};

}  // namespace cogslam
