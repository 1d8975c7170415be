#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "core/pose2.hpp"
#include "slam/mobile_sensing/partial_map.hpp"

// Compressive mobile sensing, eqs. 9 and 10: the offset between two poses from the overlap of their partial maps, after
// Lucas and Kanade (1981), with a rigid motion in place of a flow.

namespace cogslam {

struct OffsetConfig {
  std::vector<double> blur_cells{4.0, 2.0, 1.0, 0.5};  ///< Gaussian sigma of each pass, coarse to fine
  int iterations = 60;                                 ///< of Gauss-Newton in each pass, at most
  double stop_cells = 1e-3;                            ///< a smaller step ends a pass
  double outlier = 0.05;  ///< difference of two cells at which one counts half (Cauchy); far larger ones hardly
  double prior_sigma_cells = 3.0;           ///< of the prior's position, each way
  double prior_sigma_turn = radians(10.0);  ///< of the prior's heading [rad]
  double observable_share = 0.01;           ///< an eigenvalue below this share of the largest is not observed
  int least_overlap_cells = 40;             ///< fewer common cells give no estimate

  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

/// What the comparison says of the motion, and what it cannot say.
struct Offset {
  Pose2 T_first_second{};       ///< pose of the second map's base seen from the first's; the prior where not observed
  bool overlaps = false;        ///< at the prior the maps have enough cells in common
  bool estimated = false;       ///< enough overlap, and the last pass came to rest within 3 sigmas of the prior
  int observed_directions = 0;  ///< of 3; along the others the prior holds
  /// Of the gradient matrix over the overlap, ascending, per cell: [1/cell^2], the rotation in units of the overlap's
  /// radius (a turn that moves its rim by one cell counts as one cell).
  Eigen::Vector3d eigenvalues = Eigen::Vector3d::Zero();
  /// That of the smallest eigenvalue: x, y (in the frame of the second map) and rotation, as above; length 1.
  Eigen::Vector3d weakest = Eigen::Vector3d::Zero();
  double rms_difference = 0.0;  ///< of the two maps over the overlap, in occupancy, after the last pass
  double overlap_cells = 0.0;   ///< sum of weights
};

/// Finds the motion at which the two maps agree best over their overlap, from `prior_T_first_second` on: least sum of
/// squared differences (eq. 10) over x, y and heading (eq. 9), with both maps blurred less and less. Directions whose
/// eigenvalue is too small, as along a straight corridor, are left at the prior. Both maps must have cells of one size.
Offset estimate_offset(const PartialMap& first, const PartialMap& second, const Pose2& prior_T_first_second,
                       const OffsetConfig& config = {});

}  // namespace cogslam
