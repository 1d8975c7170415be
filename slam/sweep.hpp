#pragma once

#include <vector>

#include "sensors/readings.hpp"

namespace cogslam {

/// One usable beam in the base frame at the stamp of the scan, motion during the sweep taken out.
struct Beam {
  Eigen::Vector2d origin{0.0, 0.0};  ///< where the lidar was [m]
  Eigen::Vector2d end{0.0, 0.0};     ///< where the beam stopped, or how far it is trusted to be free [m]
  float range = 0.0F;                ///< |end - origin| [m]
  bool hit = false;                  ///< a surface stands at `end`
};

/// How a scan becomes beams.
struct SweepConfig {
  int beams = 180;  ///< at most so many are used, evenly spread over the scan: a hit beats any number of misses,
                    ///< so with very many beams noise alone thickens every wall
  double max_hit_range = 30.0;   ///< farther returns only carve [m]
  double max_free_range = 12.0;  ///< beams without a hit carve up to here [m]; a hit carves up to itself
  bool carve_no_return = false;  ///< a beam without return carves too: true in a closed world, not where glass is black
};

/// The beams of a reading's scan. A beam that says nothing (NaN, too close) is left out. Empty without a scan.
std::vector<Beam> sweep_of(const Reading& reading, const SweepConfig& config);

}  // namespace cogslam
