#include "slam/track/point_to_line.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace cogslam {
namespace {

constexpr double kStill = 1e-4;  // metres, and a turn of as many quarter radians

/// Normal equations of one round of pairs, over the small motion (x, y, theta) that follows the pose.
struct Equations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

Equations pair_up(const std::vector<SurfacePoint>& points, const LocalMap& map, const Pose2& pose, double reach,
                  const PointToLineConfig& config) {
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  Eigen::Matrix2d R;
  R << c, -s, s, c;
  Equations sum;
  for (const SurfacePoint& point : points) {
    const SurfacePoint seen{R * point.position + pose.position(), R * point.normal};
    const SurfacePoint* wall = map.nearest(seen, reach);
    if (wall == nullptr) continue;
    const double distance = wall->normal.dot(seen.position - wall->position);
    const Eigen::Vector2d n = R.transpose() * wall->normal;  // seen from the base
    const Eigen::Vector3d jacobian(n.x(), n.y(), n.y() * point.position.x() - n.x() * point.position.y());
    const double in_sigmas = distance / config.sigma;
    const double weight = config.point_share / (config.sigma * config.sigma * (1.0 + in_sigmas * in_sigmas));
    sum.information += weight * jacobian * jacobian.transpose();
    sum.gradient += weight * distance * jacobian;
  }
  return sum;
}

/// How well the points fit where they are. A point without partner speaks against the pose where the space was seen
/// free, and says little where nothing was known.
void judge(const std::vector<SurfacePoint>& points, const LocalMap& map, const PointToLineConfig& config,
           PointToLineMatch& match) {
  const auto cost_at = [&](double distance) { return std::log1p(std::pow(distance / config.sigma, 2)); };
  const double contradicted = cost_at(2.0 * config.last_reach), alone = cost_at(config.sigma);
  double cost = 0.0, paired = 0.0, against = 0.0;
  for (const SurfacePoint& point : points) {
    const SurfacePoint seen{match.T_map_base * point.position, Pose2{0.0, 0.0, match.T_map_base.theta} * point.normal};
    if (const SurfacePoint* wall = map.nearest(seen, config.last_reach)) {
      cost += cost_at(wall->normal.dot(seen.position - wall->position));
      paired += 1.0;
    } else if (map.free_at(seen.position)) {
      cost += contradicted;
      against += 1.0;
    } else {
      cost += alone;
    }
  }
  const auto n = static_cast<double>(points.size());
  match.cost += 0.5 * config.point_share * cost;
  match.paired_share = paired / n;
  match.contradicted_share = against / n;
}

}  // namespace

PointToLineMatch match_points(const std::vector<SurfacePoint>& points, const LocalMap& map, const Pose2& predicted,
                              const Eigen::Matrix3d& covariance, const PointToLineConfig& config, const Pose2& start) {
  if (points.empty() || map.empty()) return {.T_map_base = predicted, .covariance = covariance};
  PointToLineMatch match{.T_map_base = start};
  const Eigen::Matrix3d prior = covariance.inverse();
  const auto from_prediction = [&] {
    const Twist2 total = (predicted.inverse() * match.T_map_base).log();
    return Eigen::Vector3d(total.x, total.y, total.theta);
  };
  Eigen::Vector3d away = from_prediction();
  double reach = config.first_reach;
  Equations sum;
  for (int round = 0; round < config.iterations_max && !match.converged; ++round) {
    sum = pair_up(points, map, match.T_map_base, reach, config);
    const Eigen::Vector3d step = -(sum.information + prior).ldlt().solve(sum.gradient + prior * away);
    match.T_map_base = match.T_map_base * Pose2::exp({step.x(), step.y(), step.z()});
    away = from_prediction();
    const bool still = step.head<2>().norm() < kStill && std::abs(step.z()) < kStill / 4.0;
    match.converged = still && reach == config.last_reach;
    reach = std::max(config.last_reach, still ? config.last_reach : 0.6 * reach);
  }
  match.covariance = (sum.information + prior).inverse();
  match.cost = 0.5 * away.dot(prior * away);
  judge(points, map, config, match);
  return match;
}

}  // namespace cogslam
