#pragma once

#include <vector>

#include "worlds/world.hpp"

namespace cogslam {

/// What light comes back from: `surfaces` without the pieces that a pane lies on. A surface that runs along a pane,
/// within 1 mm of it, is of glass there; one that crosses it is not.
std::vector<Segment> opaque_parts(const std::vector<Segment>& surfaces, const std::vector<Segment>& panes);

}  // namespace cogslam
