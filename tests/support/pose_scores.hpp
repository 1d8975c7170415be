#pragma once

#include <Eigen/Eigenvalues>
#include <utility>

#include "slam/match/scan_matcher.hpp"
#include "slam/weight/scan_likelihood.hpp"

namespace cogslam {

/// Slow twin of an analytic fit: slope and curvature of any score by central differences over `step` (m, and rad).
template <class Score>
PoseFit fit_by_differences(const Score& score, const Pose2& pose, double step) {
  const auto at = [&](const Eigen::Vector3d& v) { return score(pose * Pose2::exp({v.x(), v.y(), v.z()})); };
  const auto unit = [&](int a) { return Eigen::Vector3d(step * Eigen::Vector3d::Unit(a)); };
  PoseFit fit{.value = score(pose)};
  Eigen::Matrix3d curvature;
  for (int a = 0; a < 3; ++a) {
    fit.gradient[a] = (at(unit(a)) - at(-unit(a))) / (2.0 * step);
    for (int b = 0; b < 3; ++b) {
      curvature(a, b) =
          (at(unit(a) + unit(b)) - at(unit(a) - unit(b)) - at(unit(b) - unit(a)) + at(-unit(a) - unit(b))) /
          (4.0 * step * step);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(-curvature);
  const Eigen::Vector3d positive = solver.eigenvalues().cwiseMax(0.0);
  fit.information = solver.eigenvectors() * positive.asDiagonal() * solver.eigenvectors().transpose();
  return fit;
}

/// A score for the matcher out of a smooth function of the pose.
template <class Score>
PoseScore smooth_score(Score score) {
  return {score, [score](const Pose2& pose) { return fit_by_differences(score, pose, 1e-4); }};
}

/// The likelihood field of a map as the filter climbs it.
inline PoseScore field_score(const ScanLikelihood& likelihood, const std::vector<Beam>& probes) {
  return {[&](const Pose2& pose) { return likelihood.field_log_likelihood(probes, pose); },
          [&](const Pose2& pose) { return likelihood.field_fit(probes, pose); }};
}

}  // namespace cogslam
