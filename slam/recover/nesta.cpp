#include "slam/recover/nesta.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/check.hpp"

namespace cogslam {
namespace {

using Eigen::ArrayXd;

/// The first steps after a restart may rise without harm.
constexpr int kFewestBetweenRestarts = 3;

/// A vector together with its image under B = A'A, the projection onto the rows of A. As both steps of NESTA only
/// combine vectors linearly, carrying the image along leaves one product with B per iteration where the printed
/// algorithm has two.
struct Tracked {
  ArrayXd x;
  ArrayXd bx;

  explicit Tracked(Eigen::Index n) : x(ArrayXd::Zero(n)), bx(ArrayXd::Zero(n)) {}
};

/// Mean of the last ten values of the smoothed norm, for the stopping rule.
class LastTen {
 public:
  void add(double value) { values_[count_++ % values_.size()] = value; }
  [[nodiscard]] bool full() const { return count_ >= values_.size(); }
  [[nodiscard]] double mean() const {
    double sum = 0.0;
    for (const double v : values_) sum += v;
    return sum / static_cast<double>(values_.size());
  }

 private:
  std::array<double, 10> values_{};
  std::size_t count_ = 0;
};

class Run {
 public:
  Run(const Nesta& nesta, const MapView& a, std::span<const double> y)
      : nesta_(nesta),
        a_(a),
        y_(y),
        n_(static_cast<Eigen::Index>(a.cols())),
        rows_(a.rows()),
        back_(n_),
        x_(n_),
        feasible_(n_),
        centre_(n_),
        gradient_(n_),
        sum_(n_) {
    a_.apply_transpose(y_, span_of(back_));
    feasible_.x = back_;
    feasible_.bx = back_;
  }

  Recovered solve();

 private:
  static std::span<double> span_of(ArrayXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

  /// out = A'A v
  void project_onto_rows(ArrayXd& v, ArrayXd& out) {
    a_.apply(span_of(v), rows_);
    a_.apply_transpose(rows_, span_of(out));
  }

  /// How much of the way to A x = y a point goes whose A' (y - A x) has this norm: lambda / (lambda + L) of the paper.
  [[nodiscard]] double pull(double distance) const { return distance > nesta_.eps ? 1.0 - nesta_.eps / distance : 0.0; }

  bool run_width(double mu, double tolerance);
  void start_from_feasible();
  double evaluate(double mu);
  void step(double mu, int k);
  [[nodiscard]] double gap() const;
  void restore_feasibility();

  const Nesta& nesta_;
  const MapView& a_;
  std::span<const double> y_;
  Eigen::Index n_;
  std::vector<double> rows_;
  ArrayXd back_;  ///< A' y
  Tracked x_, feasible_, centre_, gradient_, sum_;
  double bound_ = 0.0;  ///< the best lower bound so far; the l1 norm is never below zero
  int iterations_ = 0;
};

/// The smoothed norm at x, its gradient, the gradient's image, and the lower bound that follows from it.
double Run::evaluate(double mu) {
  gradient_.x = x_.x / x_.x.abs().max(mu);
  // huber(x) = g (x - mu g / 2)
  const double smoothed = (gradient_.x * (x_.x - 0.5 * mu * gradient_.x)).sum();
  project_onto_rows(gradient_.x, gradient_.bx);
  // With lambda = A g: y . lambda = (A'y) . g, A' lambda = B g, and ||lambda|| = ||B g||.
  const double value = (back_ * gradient_.x).sum() - nesta_.eps * gradient_.bx.matrix().norm();
  bound_ = std::max(bound_, value / std::max(1.0, gradient_.bx.abs().maxCoeff()));
  return smoothed;
}

/// One iteration's two projections and their combination.
void Run::step(double mu, int k) {
  const double weight = 0.5 * (k + 1);
  sum_.x += weight * gradient_.x;
  sum_.bx += weight * gradient_.bx;
  double pull_y = 1.0;
  double pull_z = 1.0;
  if (nesta_.eps > 0.0) {
    pull_y = pull((back_ - x_.bx + mu * gradient_.bx).matrix().norm());
    pull_z = pull((back_ - centre_.bx + mu * sum_.bx).matrix().norm());
  }
  feasible_.x = x_.x - mu * gradient_.x + pull_y * (back_ - x_.bx + mu * gradient_.bx);
  feasible_.bx = (1.0 - pull_y) * (x_.bx - mu * gradient_.bx) + pull_y * back_;
  const double tau = 2.0 / (k + 3);
  x_.x = (1.0 - tau) * feasible_.x + tau * (centre_.x - mu * sum_.x + pull_z * (back_ - centre_.bx + mu * sum_.bx));
  x_.bx = (1.0 - tau) * feasible_.bx + tau * ((1.0 - pull_z) * (centre_.bx - mu * sum_.bx) + pull_z * back_);
}

double Run::gap() const {
  const double norm = feasible_.x.abs().sum();
  return norm > 0.0 ? std::max(0.0, (norm - bound_) / norm) : 0.0;
}

void Run::start_from_feasible() {
  centre_ = feasible_;
  x_ = feasible_;
  sum_.x.setZero();
  sum_.bx.setZero();
}

/// Minimises the norm smoothed by mu. False if the iterations ran out.
bool Run::run_width(double mu, double tolerance) {
  start_from_feasible();
  LastTen history;
  double previous = std::numeric_limits<double>::infinity();
  for (int k = 0; iterations_ < nesta_.max_iterations; ++k, ++iterations_) {
    const double smoothed = evaluate(mu);
    step(mu, k);
    if (nesta_.stop_at_gap > 0.0 && gap() <= nesta_.stop_at_gap) return true;
    if (history.full() && std::abs(smoothed - history.mean()) <= tolerance * history.mean()) return true;
    history.add(smoothed);
    if (nesta_.restart && k > kFewestBetweenRestarts && smoothed > previous) {
      start_from_feasible();
      k = -1;
    }
    previous = smoothed;
  }
  return false;
}

/// Removes what rounding has added to A x - y over many iterations.
void Run::restore_feasibility() {
  a_.apply(span_of(feasible_.x), rows_);
  double squares = 0.0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = y_[i] - rows_[i];
    squares += rows_[i] * rows_[i];
  }
  a_.apply_transpose(rows_, span_of(gradient_.x));
  feasible_.x += pull(std::sqrt(squares)) * gradient_.x;
  project_onto_rows(feasible_.x, feasible_.bx);
}

Recovered Run::solve() {
  const double largest = back_.abs().maxCoeff();
  Recovered result{.x = std::vector<double>(a_.cols(), 0.0), .converged = true};
  // ||A'y|| = ||y||: zero satisfies the constraint and nothing has a smaller norm. Also keeps mu above zero.
  if (back_.matrix().norm() <= nesta_.eps || largest == 0.0) {
    result.duality_gap = 0.0;
    result.residual = back_.matrix().norm();
    return result;
  }
  const double first = 0.9 * largest;
  const double last = nesta_.mu_final > 0.0 ? nesta_.mu_final * largest : nesta_.stop_at_gap * back_.abs().mean();
  for (int t = 1; result.converged; ++t) {
    const double progress = std::min(1.0, static_cast<double>(t) / nesta_.continuation);
    const int halvings = std::max(0, t - nesta_.continuation);
    const double mu = std::ldexp(first * std::pow(std::min(1.0, last / first), progress), -halvings);
    const double tolerance = 0.1 * std::pow(nesta_.tolerance / 0.1, progress) * std::pow(0.1, halvings);
    result.converged = run_width(mu, tolerance);
    restore_feasibility();
    const bool widths_done = t >= nesta_.continuation;
    if (nesta_.stop_at_gap > 0.0 ? gap() <= nesta_.stop_at_gap : widths_done) break;
  }
  result.x.assign(feasible_.x.begin(), feasible_.x.end());
  result.iterations = iterations_;
  result.duality_gap = gap();
  result.residual = residual_norm(a_, result.x, y_);
  return result;
}

}  // namespace

Recovered recover(const Nesta& nesta, const MapView& a, std::span<const double> y) {
  EXPECTS(y.size() == a.rows());
  EXPECTS(a.orthonormal_rows());
  EXPECTS(nesta.eps >= 0.0 && nesta.mu_final >= 0.0 && nesta.mu_final <= 0.9);
  EXPECTS(nesta.mu_final > 0.0 || nesta.stop_at_gap > 0.0);
  EXPECTS(nesta.continuation >= 1 && nesta.tolerance > 0.0 && nesta.stop_at_gap >= 0.0);
  return Run(nesta, a, y).solve();
}

Nesta Nesta::to_gap(double gap, double eps) {
  return {.eps = eps, .mu_final = 0.0, .continuation = 3, .tolerance = 1e-12, .stop_at_gap = gap, .restart = true};
}

}  // namespace cogslam
