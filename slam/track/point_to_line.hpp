#pragma once

#include "core/pose2.hpp"
#include "slam/track/local_map.hpp"

namespace cogslam {

struct PointToLineConfig {
  double first_reach = 0.5;  ///< pairs of points are sought within this distance at first [m]
  double last_reach = 0.15;  ///< and at last
  double sigma = 0.02;       ///< of a point about its wall [m]
  double point_share = 0.5;  ///< independent points per point: neighbours err alike
  int iterations_max = 20;
};

/// A pose found by pairing points with walls.
struct PointToLineMatch {
  Pose2 T_map_base{};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the small motion that follows [m, m, rad]
  double paired_share = 0.0;                             ///< of the points, within the last reach
  double contradicted_share = 0.0;  ///< of the points: without partner, where a key scan saw through
  double cost = 0.0;  ///< minus the log posterior, up to a constant: what competing matches are told apart by
  bool converged = false;
};

/// Point-to-line ICP (Censi 2008) as maximum a posteriori: minimises the squared distances of points to the lines of
/// their nearest neighbours in `map`, with Cauchy's weights, and the squared motion away from `predicted` in units of
/// `covariance`. Where the walls do not hold the pose (along a corridor), the prediction does. The search
/// begins at `start`. Without points, or an empty map, the result is the prediction.
PointToLineMatch match_points(const std::vector<SurfacePoint>& points, const LocalMap& map, const Pose2& predicted,
                              const Eigen::Matrix3d& covariance, const PointToLineConfig& config, const Pose2& start);

}  // namespace cogslam
