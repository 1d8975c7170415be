#pragma once

#include "eval/scenario.hpp"

namespace cogslam {

/// A drive of two seconds through a filter and a mapper, at two cell sizes.
inline Scenario short_scenario() {
  return read_scenario(ConfigSection::parse(R"(
duration_s: 2
world: {kind: simple}
sensors: {camera: {enabled: false}, lidar: {beams: 61}}
drive: {waypoints: [{x_m: 1, y_m: 0}]}
slam: {particles: 4, cell_sizes_m: [0.5, 0.2]}
variants:
  - name: og
  - {name: truth_og, true_poses: true}
)",
                                            "short.yaml"),
                       "short");
}

}  // namespace cogslam
