#pragma once

#include <vector>

#include "slam/sweep.hpp"

namespace cogslam {

/// A piece of a wall as a laser saw it.
struct SurfacePoint {
  Eigen::Vector2d position{0.0, 0.0};  ///< [m]
  Eigen::Vector2d normal{0.0, 0.0};    ///< of unit length, towards the laser
};

/// The returns of a sweep whose neighbours lie on one line with them, as pieces of surface in the base frame. The
/// normal is that of the line fitted to up to `kNeighbours` returns on either side that follow each other by less than
/// `gap` [m]; a return with fewer than two such neighbours, or whose neighbours do not form a line, is left out.
std::vector<SurfacePoint> surface_points(const std::vector<Beam>& sweep, double gap);

}  // namespace cogslam
