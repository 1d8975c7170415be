#pragma once

#include "slam/mobile_sensing/partial_map.hpp"

namespace cogslam {

/// Adds the evidence of a partial map (eq. 7) to a map's log-odds, for a base at `T_map_base`: each cell of the map
/// takes what the partial map says at its centre. Cells without weight say nothing; those outside `log_odds` are lost.
void stitch(Grid<double>& log_odds, const PartialMap& map, const Pose2& T_map_base);

}  // namespace cogslam
