#pragma once

#include <Eigen/Core>
#include <span>

#include "worlds/world.hpp"

namespace cogslam {

/// How far the needle of a compass at `p_map` is turned from magnetic north by magnets [rad], counter-clockwise.
///
/// The earth's horizontal field (1, towards `declination` clockwise from the map's +y) and those of dipoles add up:
/// B(r) = (reach / r)^3 (3 (m . u) u - m), m the unit moment, u from the magnet to the compass (Jackson, Classical
/// Electrodynamics, sec. 5.6). So far away the deflection falls as 1/r^3. Within a tenth of `reach` the field is taken
/// as at that distance.
double compass_deflection(std::span<const Magnet> magnets, const Eigen::Vector2d& p_map, double declination);

}  // namespace cogslam
