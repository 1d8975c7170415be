#pragma once

#include "core/config.hpp"
#include "worlds/world.hpp"

// Things of the world that mislead the robot's sensors. Each stands at a place, and none has an end.

namespace cogslam {

/// `x_m`, `y_m`, `radius_m`, `friction`.
SlipPatch read_slip_patch(ConfigSection& section);

/// A pane of glass, `from_m` to `to_m`. InputError where the two are one point.
Segment read_glass(ConfigSection& section);

/// `x_m`, `y_m`, `reach_m`, `axis_deg`.
Magnet read_magnet(ConfigSection& section);

}  // namespace cogslam
