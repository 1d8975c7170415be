#include "eval/metrics/path_error.hpp"

#include "core/angle.hpp"
#include "core/check.hpp"

namespace cogslam {
namespace {

Eigen::Vector2d mean_position(std::span<const Pose2> path) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Pose2& T : path) sum += T.position();
  return sum / static_cast<double>(path.size());
}

}  // namespace

std::optional<PathError> path_error(std::span<const Pose2> truth, std::span<const Pose2> estimate) {
  EXPECTS(truth.size() == estimate.size());
  if (truth.empty()) return std::nullopt;
  PathError sum;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double turn = angle_difference(estimate[i].theta, truth[i].theta);
    sum.position_mse += (estimate[i].position() - truth[i].position()).squaredNorm();
    sum.heading_mse += turn * turn;
  }
  const auto n = static_cast<double>(truth.size());
  return PathError{sum.position_mse / n, sum.heading_mse / n};
}

Pose2 align_paths(std::span<const Pose2> truth, std::span<const Pose2> estimate) {
  EXPECTS(truth.size() == estimate.size() && !truth.empty());
  const Eigen::Vector2d truth_mean = mean_position(truth), estimate_mean = mean_position(estimate);
  // In the plane the best rotation is the direction of sum conj(e) t, positions taken as complex numbers.
  double along = 0.0, across = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector2d t = truth[i].position() - truth_mean, e = estimate[i].position() - estimate_mean;
    along += e.dot(t);
    across += e.x() * t.y() - e.y() * t.x();
  }
  const Pose2 turn{0.0, 0.0, std::atan2(across, along)};
  const Eigen::Vector2d shift = truth_mean - turn * estimate_mean;
  return {shift.x(), shift.y(), turn.theta};
}

std::optional<double> ate_rmse(std::span<const Pose2> truth, std::span<const Pose2> estimate) {
  EXPECTS(truth.size() == estimate.size());
  if (truth.size() < 2) return std::nullopt;
  const Pose2 T_truth_estimate = align_paths(truth, estimate);
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    sum += (T_truth_estimate * estimate[i].position() - truth[i].position()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

std::optional<RelativePoseError> relative_pose_error(std::span<const Pose2> truth, std::span<const Pose2> estimate,
                                                     double distance) {
  EXPECTS(truth.size() == estimate.size() && distance > 0.0);
  const std::vector<double> travel = travelled(truth);
  double trans_sum = 0.0, rot_sum = 0.0;
  std::size_t segments = 0, j = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    while (j < truth.size() && travel[j] - travel[i] < distance) ++j;
    if (j == truth.size()) break;
    const Pose2 error = (truth[i].inverse() * truth[j]).inverse() * (estimate[i].inverse() * estimate[j]);
    trans_sum += error.position().squaredNorm();
    rot_sum += error.theta * error.theta;
    ++segments;
  }
  if (segments == 0) return std::nullopt;
  const auto n = static_cast<double>(segments);
  return RelativePoseError{segments, std::sqrt(trans_sum / n), std::sqrt(rot_sum / n)};
}

std::vector<double> travelled(std::span<const Pose2> path) {
  std::vector<double> travel(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    travel[i] = travel[i - 1] + (path[i].position() - path[i - 1].position()).norm();
  }
  return travel;
}

}  // namespace cogslam
