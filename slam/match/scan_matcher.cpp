#include "slam/match/scan_matcher.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace cogslam {
namespace {

constexpr double kLever = 4.0;  // metres: a turn is worth what it moves a point this far away
constexpr int kClimbLimit = 60;

/// The posterior over small motions away from the prediction.
class Posterior {
 public:
  Posterior(const PoseScore& score, const Pose2& predicted, const Eigen::Matrix3d& covariance)
      : score_(score), predicted_(predicted), information_(covariance.inverse()) {}

  double likelihood(const Eigen::Vector3d& v) {
    ++evaluations;
    return score_(pose(v));
  }
  double operator()(const Eigen::Vector3d& v) { return likelihood(v) - 0.5 * v.dot(information_ * v); }
  [[nodiscard]] Pose2 pose(const Eigen::Vector3d& v) const { return predicted_ * Pose2::exp({v.x(), v.y(), v.z()}); }
  [[nodiscard]] const Eigen::Matrix3d& information() const { return information_; }

  int evaluations = 0;

 private:
  const PoseScore& score_;
  Pose2 predicted_;
  Eigen::Matrix3d information_;
};

struct Best {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  double value = 0.0;
};

Best search_coarse(Posterior& posterior, const Eigen::Matrix3d& covariance, const ScanMatcherConfig& config) {
  const Eigen::Vector3d step(config.coarse_step, config.coarse_step, config.coarse_step / kLever);
  std::array<int, 3> reach{};
  for (int k = 0; k < 3; ++k) {
    const double half_width = config.window_sigmas * std::sqrt(covariance(k, k));
    reach[static_cast<std::size_t>(k)] =
        std::min(config.coarse_steps_max, static_cast<int>(std::lround(half_width / step[k])));
  }
  Best best{Eigen::Vector3d::Zero(), posterior(Eigen::Vector3d::Zero())};
  for (int i = -reach[0]; i <= reach[0]; ++i) {
    for (int j = -reach[1]; j <= reach[1]; ++j) {
      for (int k = -reach[2]; k <= reach[2]; ++k) {
        const Eigen::Vector3d v(i * step[0], j * step[1], k * step[2]);
        const double value = posterior(v);
        if (value > best.value) best = {v, value};
      }
    }
  }
  return best;
}

/// One round of steps along each axis; false when none of them leads up.
bool climb_once(Posterior& posterior, Best& best, double step) {
  Best from = best;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Eigen::Vector3d v = from.v;
      v[axis] += sign * (axis == 2 ? step / kLever : step);
      const double value = posterior(v);
      if (value > best.value) best = {v, value};
    }
  }
  return best.value > from.value;
}

/// Curvature of the score by central differences over a step wide enough to bridge the cells, made positive.
Eigen::Matrix3d score_information(Posterior& posterior, const Eigen::Vector3d& mode, double step) {
  const Eigen::Vector3d h(step, step, step / kLever);
  const auto value = [&](int a, double da, int b, double db) {
    Eigen::Vector3d v = mode;
    v[a] += da * h[a];
    v[b] += db * h[b];
    return posterior.likelihood(v);
  };
  const double centre = posterior.likelihood(mode);
  Eigen::Matrix3d curvature;
  for (int a = 0; a < 3; ++a) {
    curvature(a, a) = (value(a, 1, a, 0) - 2.0 * centre + value(a, -1, a, 0)) / (h[a] * h[a]);
    for (int b = 0; b < a; ++b) {
      curvature(a, b) = curvature(b, a) =
          (value(a, 1, b, 1) - value(a, 1, b, -1) - value(a, -1, b, 1) + value(a, -1, b, -1)) / (4.0 * h[a] * h[b]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(-curvature);
  const Eigen::Vector3d positive = solver.eigenvalues().cwiseMax(0.0);
  return solver.eigenvectors() * positive.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

ScanMatch match_scan(const PoseScore& score, const Pose2& predicted, const Eigen::Matrix3d& covariance,
                     const ScanMatcherConfig& config) {
  Posterior posterior(score, predicted, covariance);
  Best best = search_coarse(posterior, covariance, config);
  double step = config.coarse_step / 2.0;
  int rounds = 0;
  for (; step >= config.finest_step && rounds < kClimbLimit; ++rounds) {
    if (!climb_once(posterior, best, step)) step /= 2.0;
  }
  const Eigen::Matrix3d information =
      posterior.information() + score_information(posterior, best.v, config.coarse_step / 2.0);
  return {.T_map_base = posterior.pose(best.v),
          .log_posterior = best.value,
          .covariance = information.inverse(),
          .converged = step < config.finest_step,
          .evaluations = posterior.evaluations};
}

}  // namespace cogslam
