#include "slam/recover/basis_pursuit.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/check.hpp"

namespace cogslam {
namespace {

using Eigen::ArrayXd;

constexpr double kRelaxation = 1.8;  // in (0, 2); beyond 1 a step goes past its target, which is faster here
constexpr int kBetweenLooksAtMeans = 16;
constexpr int kFirstMean = 64;  // iterations in the first mean; each later one takes half as many again

std::span<double> span_of(ArrayXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

class Run {
 public:
  Run(const BasisPursuit& pursuit, const MapView& a, std::span<const double> y);
  Recovered solve();

 private:
  void project();
  void try_pair(const ArrayXd& feasible, const ArrayXd& dual, double scale);
  void add_to_means();
  void shrink();
  [[nodiscard]] double gap() const { return std::max(0.0, (best_ - bound_) / best_); }

  const BasisPursuit& pursuit_;
  const MapView& a_;
  std::span<const double> y_;
  std::vector<double> rows_;
  ArrayXd back_;                     ///< A' y
  ArrayXd state_, feasible_, dual_;  ///< z, its projection x, and x - z = A' lambda
  ArrayXd feasible_sum_, dual_sum_;  ///< over the iterations of the present mean
  ArrayXd best_x_;
  double threshold_ = 0.0;
  double best_ = std::numeric_limits<double>::infinity();
  double bound_ = 0.0;  ///< the l1 norm is never below zero
  int in_mean_ = 0;
  int mean_length_ = kFirstMean;
};

Run::Run(const BasisPursuit& pursuit, const MapView& a, std::span<const double> y)
    : pursuit_(pursuit), a_(a), y_(y), rows_(a.rows()), back_(static_cast<Eigen::Index>(a.cols())) {
  a_.apply_transpose(y_, span_of(back_));
  threshold_ = pursuit_.threshold * back_.abs().mean();
  state_ = feasible_ = best_x_ = back_;
  dual_ = feasible_sum_ = dual_sum_ = ArrayXd::Zero(back_.size());
}

void Run::project() {
  a_.apply(span_of(state_), rows_);
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = y_[i] - rows_[i];
  a_.apply_transpose(rows_, span_of(dual_));
  feasible_ = state_ + dual_;
}

/// `scale`: a factor on both, > 0.
void Run::try_pair(const ArrayXd& feasible, const ArrayXd& dual, double scale) {
  const double norm = feasible.abs().sum() / scale;
  if (norm < best_) {
    best_ = norm;
    best_x_ = feasible / scale;
  }
  // y . lambda = (A' y) . (A' lambda), as A A' = I.
  bound_ = std::max(bound_, (back_ * dual).sum() / std::max(scale * threshold_, dual.abs().maxCoeff()));
}

void Run::add_to_means() {
  feasible_sum_ += feasible_;
  dual_sum_ += dual_;
  if (++in_mean_ % kBetweenLooksAtMeans != 0) return;
  try_pair(feasible_sum_, dual_sum_, in_mean_);
  if (in_mean_ < mean_length_) return;
  in_mean_ = 0;
  mean_length_ += mean_length_ / 2;
  feasible_sum_.setZero();
  dual_sum_.setZero();
}

/// Moves z towards the soft threshold of the point opposite to it.
void Run::shrink() {
  const auto opposite = feasible_ + dual_;
  state_ += kRelaxation * (opposite - opposite.max(-threshold_).min(threshold_) - feasible_);
}

Recovered Run::solve() {
  Recovered result{.converged = true};
  result.duality_gap = 0.0;
  if (threshold_ > 0.0) {
    project();
    try_pair(feasible_, dual_, 1.0);
    while (gap() > pursuit_.stop_at_gap && result.iterations < pursuit_.max_iterations) {
      shrink();
      project();
      ++result.iterations;
      try_pair(feasible_, dual_, 1.0);
      add_to_means();
    }
    result.duality_gap = gap();
    result.converged = *result.duality_gap <= pursuit_.stop_at_gap;
  }
  result.x.assign(best_x_.begin(), best_x_.end());
  return result;
}

}  // namespace

Recovered recover(const BasisPursuit& pursuit, const MapView& a, std::span<const double> y) {
  EXPECTS(y.size() == a.rows() && !y.empty());
  EXPECTS(a.orthonormal_rows());
  EXPECTS(pursuit.stop_at_gap > 0.0 && pursuit.threshold > 0.0 && pursuit.max_iterations >= 0);
  Recovered result = Run(pursuit, a, y).solve();
  result.residual = residual_norm(a, result.x, y);
  return result;
}

}  // namespace cogslam
