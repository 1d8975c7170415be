#pragma once

#include "core/config.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Reads the `world:` section of a scenario and builds the world. Lengths in metres, all keys optional:
///
///     kind: simple | cornered | cluttered | hallway | polygons | map
///     width_m, length_m, variant        # of a room; see rooms.hpp. The hallway has none: see hallway.hpp
///     walls:                            # of `polygons`: loops, at least one
///       - corners_m: [[-2, -1.5], [2, -1.5], [2, 1.5], [-2, 1.5]]
///     map, unknown, simplify_m          # of `map`; see map_config.hpp
///     obstacles:                        # loops or boxes, in addition to those of the room
///       - corners_m: [[0, 0], [0.4, 0], [0.2, 0.5]]
///       - box: {x_m: 1, y_m: 0.5, heading_deg: 30, width_m: 0.4, length_m: 0.6}
///     start: {x_m, y_m, heading_deg}    # default: the start of the room
///     floor: {kind: carpet | wood | concrete | tile | plain, contrast, seed}
///     slip_patches:
///       - {x_m: 0, y_m: 0, radius_m: 0.5, friction: 0.2}
///
/// InputError at the key's place where a loop has fewer than three corners, no area or crosses itself, where walls do
/// not close around the start, where the start lies in an obstacle, and where the world is over 200 m wide or long.
World read_world(ConfigSection& section);

}  // namespace cogslam
