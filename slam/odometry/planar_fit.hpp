#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/pose2.hpp"

namespace cogslam {

/// One point of the floor [m] in the base frame, as it stood before and as it stands now.
struct FloorPair {
  Eigen::Vector2d before{0.0, 0.0};
  Eigen::Vector2d now{0.0, 0.0};
};

struct PlanarFitConfig {
  double inlier_distance = 0.001;  ///< [m] a pair counts if the motion explains it within this
  double loss_scale = 0.0003;      ///< [m] where the Huber loss turns from square to straight
  int hypotheses = 40;             ///< two-point motions tried for the start
  int min_inliers = 3;
};

struct PlanarFit {
  Pose2 T_before_now{};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the small motion after it, if residuals are independent
  int inliers = 0;
  double rms = 0.0;        ///< residual per coordinate over the inliers [m]
  bool converged = false;  ///< the solver met its own stopping rule
};

/// The rigid motion T that best explains `before = T * now` for points that lie still on the floor.
///
/// Start: the two-point motion with most inliers (RANSAC, over a fixed sequence of pairs, so that nothing is random).
/// Then Levenberg-Marquardt (ceres::TinySolver) with Huber's loss over the pairs near that start. The covariance is
/// s^2 (J^T J)^-1 over the inliers, s^2 their residual variance. Nothing where fewer than `min_inliers` pairs agree.
std::optional<PlanarFit> fit_planar_motion(std::span<const FloorPair> pairs, const PlanarFitConfig& config);

}  // namespace cogslam
