#pragma once

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "slam/mobile_sensing/offset_level.hpp"

namespace cogslam {

/// Both partial maps blurred alike: what one pass of offset estimation compares.
struct OffsetLevels {
  OffsetLevel first, second;
};

/// Where the maps overlap, in cells of the second.
struct OffsetOverlap {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 1.0;  ///< root mean square distance from the centre, at least 1 [cells]
  double weight = 0.0;  ///< sum over its cells
};

/// Sums of eq. 10 over the overlap. Steps are x, y [cells] and a turn about its centre, in the frame of the second map,
/// the turn multiplied by its radius so that all three are in cells.
struct OffsetEquations {
  Eigen::Matrix3d gradients = Eigen::Matrix3d::Zero();  ///< sum of w J' J
  Eigen::Vector3d right = Eigen::Vector3d::Zero();      ///< sum of w J' r
  double squares = 0.0;                                 ///< sum of w r^2
  double weight = 0.0;
};

/// `T_cells`: the second grid's pose seen from the first, in cells between the centres of their cells (0, 0).
OffsetOverlap offset_overlap(const OffsetLevels& levels, const Pose2& T_cells);

/// The same with `overlap` as the turn's centre and unit. A difference of `outlier` counts half (Cauchy). The Jacobian
/// is that of the mean of both maps' gradients, which reaches second order (Malis 2004).
OffsetEquations offset_equations(const OffsetLevels& levels, const Pose2& T_cells, const OffsetOverlap& overlap,
                                 double outlier);

}  // namespace cogslam
