#pragma once

#include <functional>

#include "core/pose2.hpp"
#include "slam/match/pose_fit.hpp"

namespace cogslam {

/// How a pose is sought around its prediction.
struct ScanMatcherConfig {
  double sharpness = 9.0;      ///< a scan counts so many times more in a match than in a weight
  double window_sigmas = 2.5;  ///< half width of the coarse search, in standard deviations of the motion
  double coarse_step = 0.1;    ///< [m]; the coarse turn step moves a point at 4 m by as much
  int coarse_steps_max = 10;   ///< per direction, however wide the motion's spread
};

/// How far the search, and the climb after it, may take a point that lies `distance` from the robot [m].
double farthest_move(const Eigen::Matrix3d& covariance, double distance, const ScanMatcherConfig& config);

/// The pose that explains scan and motion best, and how sharply.
struct ScanMatch {
  Pose2 T_map_base{};          ///< the mode
  double log_posterior = 0.0;  ///< log p(z | x) + log p(x | u) there, up to the constant of p(x | u)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the small motion about it [m, m, rad]
  bool converged = false;                                ///< false: the climb stopped at its limit of steps
  int evaluations = 0;
};

/// log p(z | x) of a pose, and the same with slope and information.
struct PoseScore {
  std::function<double(const Pose2&)> value;
  std::function<PoseFit(const Pose2&)> fit;
};

/// Maximises score(x) + log N(x; predicted, covariance): a coarse grid search over the motion's spread, then Newton's
/// method on the score's own fit, and one step by differences over a quarter of a coarse step. The covariance joins the
/// curvature of the score at the mode with the motion's information, so a direction that the scan does not see (along a
/// corridor) keeps the motion's spread.
ScanMatch match_scan(const PoseScore& score, const Pose2& predicted, const Eigen::Matrix3d& covariance,
                     const ScanMatcherConfig& config);

}  // namespace cogslam
