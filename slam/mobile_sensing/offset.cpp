#include "slam/mobile_sensing/offset.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/check.hpp"
#include "slam/mobile_sensing/offset_equations.hpp"

namespace cogslam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLeastGradient = 1e-8;  // an eigenvalue below is rounding [1/cell^2]; faint walls have 1e-5
constexpr double kLargestJump = 0.1;     // of the minimum between two sides of a place where steps turn back [cells]

constexpr double kFarthest = 3.0;  // sigmas of the prior; farther lies another wall of the same look

/// Poses in cells, between cell centres of the two grids rather than between the bases.
class Grids {
 public:
  Grids(const GridFrame& first, const GridFrame& second)
      : cell_(first.cell_size),
        T_first_grid_{first.lattice_min.x + 0.5, first.lattice_min.y + 0.5, 0.0},
        T_second_grid_{second.lattice_min.x + 0.5, second.lattice_min.y + 0.5, 0.0} {}

  [[nodiscard]] Pose2 to_cells(const Pose2& T) const {
    return T_first_grid_.inverse() * Pose2{T.x / cell_, T.y / cell_, T.theta} * T_second_grid_;
  }
  [[nodiscard]] Pose2 to_metres(const Pose2& T_cells) const {
    const Pose2 T = T_first_grid_ * T_cells * T_second_grid_.inverse();
    return {T.x * cell_, T.y * cell_, T.theta};
  }

 private:
  double cell_;
  Pose2 T_first_grid_, T_second_grid_;
};

class Registration {
 public:
  Registration(const PartialMap& first, const PartialMap& second, const OffsetConfig& config) : config_(config) {
    for (const double sigma : config.blur_cells) passes_.push_back({{first, sigma}, {second, sigma}});
  }

  [[nodiscard]] Offset run(Pose2 T_cells);
  [[nodiscard]] const Pose2& motion() const { return T_; }

 private:
  [[nodiscard]] OffsetEquations equations(const OffsetLevels& levels) const {
    return offset_equations(levels, T_, overlap_, config_.outlier);
  }
  void decide_observable(const OffsetLevels& levels, Offset& out);
  bool pass(const OffsetLevels& levels);
  bool all_passes();
  [[nodiscard]] Vector3d from_prior() const;
  [[nodiscard]] bool is_near_prior() const;
  [[nodiscard]] Pose2 step(const Vector3d& delta) const;

  const OffsetConfig& config_;
  std::vector<OffsetLevels> passes_;
  Pose2 T_{}, prior_{};
  OffsetOverlap overlap_;
  Matrix3d observed_ = Matrix3d::Zero();  ///< columns: the directions that may move; the others are zero
};

void Registration::decide_observable(const OffsetLevels& levels, Offset& out) {
  const OffsetEquations sums = equations(levels);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(sums.gradients / sums.weight);
  out.eigenvalues = solver.eigenvalues();
  out.weakest = solver.eigenvectors().col(0);
  observed_.setZero();
  for (int i = 0; i < 3; ++i) {
    const double least = std::max(kLeastGradient, config_.observable_share * out.eigenvalues[2]);
    if (!(out.eigenvalues[i] >= least)) continue;
    observed_.col(out.observed_directions++) = solver.eigenvectors().col(i);
  }
}

/// A turn about the overlap's centre, then a shift, both in the frame of the second map.
Pose2 Registration::step(const Vector3d& delta) const {
  const double turn = delta.z() / overlap_.radius;
  const Vector2d moved = overlap_.centre + delta.head<2>() - Pose2{0.0, 0.0, turn} * overlap_.centre;
  return {moved.x(), moved.y(), turn};
}

/// The motion from the prior to here, as a step.
Vector3d Registration::from_prior() const {
  const Pose2 T = prior_.inverse() * T_;
  const Vector2d moved = T * overlap_.centre - overlap_.centre;
  return {moved.x(), moved.y(), T.theta * overlap_.radius};
}

bool Registration::is_near_prior() const {
  const Vector3d moved = from_prior();
  return moved.head<2>().norm() <= kFarthest * config_.prior_sigma_cells &&
         std::abs(moved.z()) <= kFarthest * config_.prior_sigma_turn * overlap_.radius;
}

bool Registration::pass(const OffsetLevels& levels) {
  const double shift = config_.outlier / config_.prior_sigma_cells;
  const double turn = config_.outlier / (config_.prior_sigma_turn * overlap_.radius);
  const Matrix3d prior = Vector3d(shift * shift, shift * shift, turn * turn).asDiagonal();
  // Cells come into the overlap and go out of it, and with them the sums jump: steps can go to and fro for ever.
  Vector3d before = Vector3d::Zero();
  double share = 1.0;
  for (int i = 0; i < config_.iterations; ++i) {
    const OffsetEquations sums = equations(levels);
    const Matrix3d seen = observed_.transpose() * (sums.gradients + prior) * observed_;
    const Vector3d pull = observed_.transpose() * (sums.right + prior * from_prior());
    const Vector3d delta = -observed_ * seen.completeOrthogonalDecomposition().solve(pull);
    const bool turns_back = delta.dot(before) < 0.0 && delta.norm() > 0.5 * before.norm();
    if (turns_back) share *= 0.5;
    T_ = T_ * step(share * delta);
    const double largest = delta.cwiseAbs().maxCoeff();
    if (share * largest < config_.stop_cells) return largest < kLargestJump;
    before = delta;
  }
  return false;
}

/// Whether the last one comes to rest.
bool Registration::all_passes() {
  bool rests = false;
  for (const OffsetLevels& levels : passes_) rests = pass(levels);
  return rests;
}

Offset Registration::run(Pose2 T_cells) {
  T_ = prior_ = T_cells;
  Offset out;
  overlap_ = offset_overlap(passes_.back(), T_);
  out.overlap_cells = overlap_.weight;
  out.overlaps = overlap_.weight >= config_.least_overlap_cells;
  if (!out.overlaps) return out;
  decide_observable(passes_[passes_.size() / 2], out);
  bool rests = out.observed_directions > 0 && all_passes();
  if (!is_near_prior() && out.observed_directions > 1) {
    observed_.col(0).setZero();  // it slid along the weakest one that seemed observed
    --out.observed_directions;
    T_ = prior_;
    rests = all_passes();
  }
  const OffsetEquations last = equations(passes_.back());
  out.overlap_cells = last.weight;
  out.rms_difference = last.weight > 0.0 ? std::sqrt(last.squares / last.weight) : 0.0;
  out.estimated = rests && is_near_prior() && last.weight >= config_.least_overlap_cells;
  return out;
}

}  // namespace

std::string OffsetConfig::check() const {
  if (blur_cells.empty()) return "blur_cells: expected at least one pass";
  for (const double sigma : blur_cells) {
    if (!(sigma > 0.0)) return "blur_cells: expected more than 0";
  }
  if (iterations < 1) return "iterations: expected at least 1";
  if (!(stop_cells > 0.0)) return "stop_cells: expected more than 0";
  if (!(outlier > 0.0)) return "outlier: expected more than 0";
  if (!(prior_sigma_cells > 0.0 && prior_sigma_turn > 0.0)) return "prior_sigma: expected more than 0";
  if (!(observable_share >= 0.0 && observable_share < 1.0))
    return "observable_share: expected 0 or more and less than 1";
  if (least_overlap_cells < 1) return "least_overlap_cells: expected at least 1";
  return "";
}

Offset estimate_offset(const PartialMap& first, const PartialMap& second, const Pose2& prior_T_first_second,
                       const OffsetConfig& config) {
  EXPECTS(config.check().empty());
  EXPECTS(first.occupancy.frame().cell_size == second.occupancy.frame().cell_size);
  const Grids grids(first.occupancy.frame(), second.occupancy.frame());
  Registration registration(first, second, config);
  Offset out = registration.run(grids.to_cells(prior_T_first_second));
  out.T_first_second = out.estimated ? grids.to_metres(registration.motion()) : prior_T_first_second;
  return out;
}

}  // namespace cogslam
