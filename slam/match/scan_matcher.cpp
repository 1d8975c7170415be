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
constexpr int kClimbSteps = 4;   // coarse steps: farther from where the search ends no climb is expected to lead
constexpr double kStill = 1e-3;  // metres: a shorter step is an arrival; the last step goes on from there

/// The posterior over small motions away from the prediction.
class Posterior {
 public:
  Posterior(const PoseScore& score, const Pose2& predicted, const Eigen::Matrix3d& covariance)
      : score_(score), predicted_(predicted), information_(covariance.inverse()) {}

  double likelihood(const Eigen::Vector3d& v) {
    ++evaluations;
    return score_.value(pose(v));
  }
  PoseFit fit(const Eigen::Vector3d& v) {
    ++evaluations;
    return score_.fit(pose(v));
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

/// Of a small motion [m].
double length(const Eigen::Vector3d& v) { return v.cwiseProduct(Eigen::Vector3d(1.0, 1.0, kLever)).norm(); }

/// A point of the climb, and the posterior about it.
struct Place {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

Place place_at(Posterior& posterior, const Eigen::Vector3d& v) {
  const PoseFit fit = posterior.fit(v);
  return {v, fit.value - 0.5 * v.dot(posterior.information() * v), fit.gradient - posterior.information() * v,
          fit.information + posterior.information()};
}

/// A Newton step, shortened until it leads up; how far it led [m], 0 where no share of it leads up. Newton, because
/// shift and turn are tied together where all surfaces lie ahead: steps along single axes stop on that ridge.
double step_uphill(Posterior& posterior, Place& place) {
  const Eigen::Vector3d newton = place.information.ldlt().solve(place.gradient);
  for (double share = 1.0; share > 0.1; share /= 2.0) {
    const Place next = place_at(posterior, place.v + share * newton);
    if (next.value <= place.value) continue;
    place = next;
    return share * length(newton);
  }
  return 0.0;
}

/// Climbs by the score's own fit; false when it stopped at the limit of steps.
bool climb(Posterior& posterior, Place& place) {
  for (int round = 0; round < kClimbLimit; ++round) {
    if (step_uphill(posterior, place) <= kStill) return true;
  }
  return false;
}

/// Slope and curvature by differences of values and slopes over a step that bridges the cells: the field's own have
/// creases, and none of it inside a large cell.
PoseFit fit_across_cells(Posterior& posterior, const Place& place, double step) {
  const Eigen::Vector3d h(step, step, step / kLever);
  PoseFit fit{.value = place.value};
  Eigen::Matrix3d curvature;
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d away = h[a] * Eigen::Vector3d::Unit(a);
    const Place after = place_at(posterior, place.v + away), before = place_at(posterior, place.v - away);
    fit.gradient[a] = (after.value - before.value) / (2.0 * h[a]);
    curvature.col(a) = (after.gradient - before.gradient) / (2.0 * h[a]);
    curvature(a, a) = (after.value - 2.0 * place.value + before.value) / (h[a] * h[a]);
  }
  // The motion's part is known; what the scan adds must not take away from it.
  const Eigen::Matrix3d scan = -0.5 * (curvature + curvature.transpose()) - posterior.information();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scan);
  const Eigen::Vector3d positive = solver.eigenvalues().cwiseMax(0.0);
  fit.information =
      posterior.information() + solver.eigenvectors() * positive.asDiagonal() * solver.eigenvectors().transpose();
  return fit;
}

}  // namespace

double farthest_move(const Eigen::Matrix3d& covariance, double distance, const ScanMatcherConfig& config) {
  const Eigen::Vector3d sigma = covariance.diagonal().cwiseSqrt();
  // Drift kept over a long way spreads by hundreds of metres; the search does not reach so far.
  const double most = (config.coarse_steps_max + kClimbSteps) * config.coarse_step;
  const Eigen::Vector3d reach =
      ((config.window_sigmas + 1.0) * sigma).cwiseMin(Eigen::Vector3d(most, most, most / kLever));
  return reach.head<2>().norm() + distance * reach.z();
}

ScanMatch match_scan(const PoseScore& score, const Pose2& predicted, const Eigen::Matrix3d& covariance,
                     const ScanMatcherConfig& config) {
  Posterior posterior(score, predicted, covariance);
  Place place = place_at(posterior, search_coarse(posterior, covariance, config).v);
  const bool converged = climb(posterior, place);
  // The field has bumps of the size of its cells, and their tops lie up to 2 cm off the pose. The last step looks
  // across them, and is taken whether or not it leads up a bump.
  const PoseFit fit = fit_across_cells(posterior, place, config.coarse_step / 4.0);
  const Eigen::Vector3d last = fit.information.ldlt().solve(fit.gradient);
  if (length(last) <= config.coarse_step / 2.0) place = place_at(posterior, place.v + last);
  return {.T_map_base = posterior.pose(place.v),
          .log_posterior = place.value,
          .covariance = fit_across_cells(posterior, place, config.coarse_step / 2.0).information.inverse(),
          .converged = converged,
          .evaluations = posterior.evaluations};
}

}  // namespace cogslam
