#include "slam/match/scan_matcher.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace cogslam {
namespace {

constexpr double kLever = 4.0;  // metres: a turn is worth what it moves a point this far away
constexpr int kClimbLimit = 20;
constexpr double kStill = 1e-4;  // metres: a shorter step is an arrival

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

/// The score about a point, to second order: by differences over a step wide enough to bridge the cells.
struct Quadratic {
  Eigen::Vector3d gradient;
  Eigen::Matrix3d information;  ///< the negated curvature, made positive
};

Quadratic fit_quadratic(Posterior& posterior, const Eigen::Vector3d& v, double step) {
  const Eigen::Vector3d h(step, step, step / kLever);
  const auto value = [&](int a, double da, int b, double db) {
    Eigen::Vector3d at = v;
    at[a] += da * h[a];
    at[b] += db * h[b];
    return posterior.likelihood(at);
  };
  const double centre = posterior.likelihood(v);
  Quadratic fit;
  Eigen::Matrix3d curvature;
  for (int a = 0; a < 3; ++a) {
    const double after = value(a, 1, a, 0), before = value(a, -1, a, 0);
    fit.gradient[a] = (after - before) / (2.0 * h[a]);
    curvature(a, a) = (after - 2.0 * centre + before) / (h[a] * h[a]);
    for (int b = 0; b < a; ++b) {
      curvature(a, b) = curvature(b, a) =
          (value(a, 1, b, 1) - value(a, 1, b, -1) - value(a, -1, b, 1) + value(a, -1, b, -1)) / (4.0 * h[a] * h[b]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(-curvature);
  const Eigen::Vector3d positive = solver.eigenvalues().cwiseMax(0.0);
  fit.information = solver.eigenvectors() * positive.asDiagonal() * solver.eigenvectors().transpose();
  return fit;
}

/// One Newton step uphill, shortened until it leads up; false when no share of it does. Newton, because shift and turn
/// are tied together where all surfaces lie ahead: steps along single axes stop on that ridge, short of its top.
bool climb_once(Posterior& posterior, Best& best, double step) {
  const Quadratic fit = fit_quadratic(posterior, best.v, step);
  const Eigen::Vector3d gradient = fit.gradient - posterior.information() * best.v;
  const Eigen::Vector3d newton = (fit.information + posterior.information()).ldlt().solve(gradient);
  for (double share = 1.0; share > 0.1; share /= 2.0) {
    const Eigen::Vector3d v = best.v + share * newton;
    const double value = posterior(v);
    if (value > best.value) {
      best = {v, value};
      return share * newton.cwiseProduct(Eigen::Vector3d(1.0, 1.0, kLever)).norm() > kStill;
    }
  }
  return false;
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
      posterior.information() + fit_quadratic(posterior, best.v, config.coarse_step / 2.0).information;
  return {.T_map_base = posterior.pose(best.v),
          .log_posterior = best.value,
          .covariance = information.inverse(),
          .converged = step < config.finest_step,
          .evaluations = posterior.evaluations};
}

}  // namespace cogslam
