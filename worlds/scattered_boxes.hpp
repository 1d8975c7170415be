#pragma once

#include <optional>

#include "core/rng.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Smallest distance between two loops [m]; 0 where they touch. One within the other counts by its edges, too.
double gap(const Polygon& a, const Polygon& b);

/// The boxes of the shipped cluttered room, their places scaled by `scale_x` and `scale_y`.
std::vector<Polygon> shipped_boxes(double scale_x, double scale_y);

/// Draws 5 to 8 boxes within `outline`, their sides 0.2 m to 0.8 m, at least `lane` [m] from each other and from the
/// outline, and as far from the origin, where the robot starts. Nothing where no place is found for one of them.
std::optional<std::vector<Polygon>> drawn_boxes(const Polygon& outline, double lane, Rng& rng);

}  // namespace cogslam
