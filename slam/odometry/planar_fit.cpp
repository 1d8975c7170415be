#include "slam/odometry/planar_fit.hpp"

#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace cogslam {
namespace {

double squared_residual(const FloorPair& pair, const Pose2& T) { return (pair.before - T * pair.now).squaredNorm(); }

std::vector<FloorPair> pairs_within(std::span<const FloorPair> pairs, const Pose2& T, double distance) {
  std::vector<FloorPair> near;
  for (const FloorPair& pair : pairs) {
    if (squared_residual(pair, T) <= distance * distance) near.push_back(pair);
  }
  return near;
}

/// The rigid motion that carries two points onto two points as well as it can.
Pose2 two_point_motion(const FloorPair& a, const FloorPair& b) {
  const Eigen::Vector2d before = b.before - a.before, now = b.now - a.now;
  const double turn = std::atan2(now.x() * before.y() - now.y() * before.x(), now.dot(before));
  const Eigen::Vector2d shift =
      0.5 * (a.before + b.before) - Pose2{0.0, 0.0, turn} * Eigen::Vector2d(0.5 * (a.now + b.now));
  return {shift.x(), shift.y(), turn};
}

Pose2 best_two_point_motion(std::span<const FloorPair> pairs, const PlanarFitConfig& config) {
  const std::size_t n = pairs.size();
  Pose2 best;
  std::size_t most = 0;
  for (std::size_t h = 0; h < static_cast<std::size_t>(config.hypotheses); ++h) {
    // Strides through the list visit every point, and partners at all distances.
    const std::size_t i = (h * n) / static_cast<std::size_t>(config.hypotheses), j = (i + 1 + (h * 37) % (n - 1)) % n;
    const Pose2 T = two_point_motion(pairs[i], pairs[j]);
    const auto agree = static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const FloorPair& pair) {
      return squared_residual(pair, T) <= config.inlier_distance * config.inlier_distance;
    }));
    if (agree > most) most = agree, best = T;
  }
  return best;
}

/// Residuals whose sum of squares is the sum of Huber losses: r * sqrt(loss(|r|^2)) / |r|, in units of the loss scale.
struct HuberResiduals {
  std::span<const FloorPair> pairs;
  double scale;

  [[nodiscard]] int NumResiduals() const { return 2 * static_cast<int>(pairs.size()); }

  template <class T>
  bool operator()(const T* const motion, T* residuals) const {
    using std::cos, std::sin, std::sqrt;
    const T c = cos(motion[2]), s = sin(motion[2]);
    for (const FloorPair& pair : pairs) {
      T x = (c * pair.now.x() - s * pair.now.y() + motion[0] - pair.before.x()) / scale;
      T y = (s * pair.now.x() + c * pair.now.y() + motion[1] - pair.before.y()) / scale;
      const T squared = x * x + y * y;
      if (squared > 1.0) {
        const T weight = sqrt((2.0 * sqrt(squared) - 1.0) / squared);
        x *= weight;
        y *= weight;
      }
      *residuals++ = x;
      *residuals++ = y;
    }
    return true;
  }
};

using HuberFunction = ceres::TinySolverAutoDiffFunction<HuberResiduals, Eigen::Dynamic, 3>;

/// Sum over the points of J^T J, J the derivative of T * exp(motion) * p by the motion (up to a rotation).
Eigen::Matrix3d information_of_points(std::span<const FloorPair> pairs) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const FloorPair& pair : pairs) {
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << 1.0, 0.0, -pair.now.y(), 0.0, 1.0, pair.now.x();
    information += jacobian.transpose() * jacobian;
  }
  return information;
}

}  // namespace

std::optional<PlanarFit> fit_planar_motion(std::span<const FloorPair> pairs, const PlanarFitConfig& config) {
  const int least = std::max(config.min_inliers, 3);
  if (static_cast<int>(pairs.size()) < least) return std::nullopt;
  const Pose2 start = best_two_point_motion(pairs, config);
  const std::vector<FloorPair> near = pairs_within(pairs, start, 3.0 * config.inlier_distance);
  if (static_cast<int>(near.size()) < least) return std::nullopt;

  const HuberResiduals residuals{near, config.loss_scale};
  const HuberFunction function(residuals);
  ceres::TinySolver<HuberFunction> solver;
  Eigen::Vector3d motion(start.x, start.y, start.theta);
  const auto& summary = solver.Solve(function, &motion);

  PlanarFit fit;
  fit.T_before_now = {motion.x(), motion.y(), wrap_angle(motion.z())};
  fit.converged = summary.status != ceres::TinySolver<HuberFunction>::HIT_MAX_ITERATIONS;
  const std::vector<FloorPair> inliers = pairs_within(near, fit.T_before_now, config.inlier_distance);
  fit.inliers = static_cast<int>(inliers.size());
  if (fit.inliers < least) return std::nullopt;
  double squares = 0.0;
  for (const FloorPair& pair : inliers) squares += squared_residual(pair, fit.T_before_now);
  const double variance = squares / (2.0 * fit.inliers - 3.0);
  fit.rms = std::sqrt(variance);
  fit.covariance = variance * information_of_points(inliers).inverse();
  return fit;
}

}  // namespace cogslam
