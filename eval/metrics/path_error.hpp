#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/pose2.hpp"

// Pose i of the estimate belongs to pose i of the truth: one of each per scan record, in record order. Spans of
// different length break the contract; too few poses to measure anything give nothing, never 0.

namespace cogslam {

/// Mean squared error of a path in the map frame, without alignment: the start pose is given.
struct PathError {
  double position_mse = 0.0;  ///< mean of dx^2 + dy^2 [m^2]
  double heading_mse = 0.0;   ///< mean of the wrapped dtheta^2 [rad^2]

  [[nodiscard]] double position_rmse() const { return std::sqrt(position_mse); }  ///< [m]
  [[nodiscard]] double heading_rmse() const { return std::sqrt(heading_mse); }    ///< [rad]
};

/// The error over all poses; nothing where there is none.
std::optional<PathError> path_error(std::span<const Pose2> truth, std::span<const Pose2> estimate);

/// The rigid motion that brings the positions of `estimate` nearest to those of `truth`, in the least squares sense
/// (Umeyama 1991, eq. 40-42, without scale). Identity rotation where the positions do not determine one.
Pose2 align_paths(std::span<const Pose2> truth, std::span<const Pose2> estimate);

/// Absolute trajectory error: RMSE of position [m] after `align_paths` (Sturm et al. 2012). Nothing below two poses:
/// alignment makes a single one right whatever it was.
std::optional<double> ate_rmse(std::span<const Pose2> truth, std::span<const Pose2> estimate);

/// How much a path drifts over a stated distance.
struct RelativePoseError {
  std::size_t segments = 0;
  double trans_rmse = 0.0;  ///< [m]
  double rot_rmse = 0.0;    ///< [rad]
};

/// Relative pose error over segments of `distance` [m] travelled by the truth (Sturm et al. 2012; Geiger et al. 2012).
/// A segment starts at every pose and ends at the first later pose that lies at least `distance` of travel on; its
/// error is inv(inv(T_i) T_j) inv(E_i) E_j. Nothing where the truth never travels that far. Turning is no travel.
std::optional<RelativePoseError> relative_pose_error(std::span<const Pose2> truth, std::span<const Pose2> estimate,
                                                     double distance = 1.0);

/// Distance travelled from the first pose to each [m]: the sum of straight steps.
std::vector<double> travelled(std::span<const Pose2> path);

}  // namespace cogslam
