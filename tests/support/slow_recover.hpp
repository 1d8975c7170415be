#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <vector>

#include "slam/recover/kalman_cs_p.hpp"

/// The recoveries as printed, on explicit matrices: slow, obvious, and only for small problems.
namespace cogslam::slow {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Algs. 5 and 6 with matrix products throughout. `derivative_and_value` returns {H-bar, h(c)} of a mean.
template <class Constraint>
VectorXd kalman_with_matrices(const MatrixXd& H, const VectorXd& y, double P, int passes,
                              Constraint&& derivative_and_value) {
  const Eigen::Index n = H.cols();
  const MatrixXd identity = MatrixXd::Identity(n, n);
  const double Q = 0.01 * 0.01;
  MatrixXd sigma = identity;
  const MatrixXd K =
      sigma * H.transpose() * (H * sigma * H.transpose() + Q * MatrixXd::Identity(H.rows(), H.rows())).inverse();
  VectorXd c = K * y;
  sigma = (identity - K * H) * sigma;
  for (int i = 0; i < passes; ++i) {
    const auto [h, value] = derivative_and_value(c);
    const VectorXd gain = sigma * h / (h.dot(sigma * h) + P);
    c = c - gain * value;
    sigma = (identity - gain * h.transpose()) * sigma;
  }
  return c;
}

inline VectorXd kalman_cs(const MatrixXd& H, const VectorXd& y, int passes) {
  return kalman_with_matrices(H, y, 100.0 * 100.0, passes, [](const VectorXd& c) {
    VectorXd h(c.size());
    for (Eigen::Index i = 0; i < c.size(); ++i) h[i] = c[i] >= 0.0 ? 1.0 : -1.0;
    return std::pair{h, h.dot(c)};
  });
}

inline VectorXd kalman_cs_p(const MatrixXd& H, const VectorXd& y, const KalmanCsP& parameters, int passes) {
  using Reading = KalmanCsP::Reading;
  const double p = parameters.p;
  return kalman_with_matrices(H, y, parameters.norm_variance, passes, [&](const VectorXd& c) {
    double sum = 0.0;
    for (const double ci : c) sum += std::pow(std::abs(ci), p);
    const double factor = parameters.reading == Reading::kAsPrinted      ? std::pow(sum, 1.0 / (p - 1.0))
                          : parameters.reading == Reading::kTrueGradient ? std::pow(sum, 1.0 / p - 1.0)
                                                                         : p;
    VectorXd h(c.size());
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      h[i] = (c[i] >= 0.0 ? 1.0 : -1.0) * factor * std::pow(std::max(std::abs(c[i]), 1e-3), p - 1.0);
    }
    return std::pair{h, parameters.reading == Reading::kPowerSum ? sum : std::pow(sum, 1.0 / p)};
  });
}

/// NESTA word for word: two projections, each with its own products, per iteration. Widths in units of x.
struct NestaParameters {
  double eps = 0.0;
  double mu_final = 1e-5;
  int widths = 8;
  double tolerance = 1e-9;
};

inline VectorXd nesta(const MatrixXd& A, const VectorXd& b, const NestaParameters& parameters) {
  const double eps = parameters.eps;
  const auto project = [&](const VectorXd& q, double L) -> VectorXd {
    const VectorXd r = b - A * q;
    if (eps == 0.0) return q + A.transpose() * r;
    const double lambda = std::max(0.0, L * (r.norm() / eps - 1.0));
    return q + lambda / (lambda + L) * (A.transpose() * r);
  };
  VectorXd y = A.transpose() * b;
  const double mu0 = 0.9 * y.cwiseAbs().maxCoeff();
  for (int t = 1; t <= parameters.widths; ++t) {
    const double progress = static_cast<double>(t) / parameters.widths;
    const double mu = mu0 * std::pow(parameters.mu_final / mu0, progress);
    const double tolerance = 0.1 * std::pow(parameters.tolerance / 0.1, progress);
    const VectorXd centre = y;
    VectorXd x = y, sum = VectorXd::Zero(y.size());
    std::vector<double> values;
    for (int k = 0; k < 100000; ++k) {
      VectorXd g(x.size());
      double smoothed = 0.0;
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double size = std::abs(x[i]);
        g[i] = x[i] / std::max(mu, size);
        smoothed += size < mu ? x[i] * x[i] / (2.0 * mu) : size - mu / 2.0;
      }
      y = project(x - mu * g, 1.0 / mu);
      sum += (k + 1) / 2.0 * g;
      const VectorXd z = project(centre - mu * sum, 1.0 / mu);
      x = 2.0 / (k + 3) * z + (1.0 - 2.0 / (k + 3)) * y;
      if (values.size() >= 10) {
        double mean = 0.0;
        for (std::size_t j = values.size() - 10; j < values.size(); ++j) mean += values[j] / 10.0;
        if (std::abs(smoothed - mean) / mean < tolerance) break;
      }
      values.push_back(smoothed);
    }
  }
  return y;
}

/// min ||x||_1 subject to A x = y: the best basic solution, over all choices of m columns.
inline double least_l1_norm(const MatrixXd& A, const VectorXd& y) {
  const Eigen::Index m = A.rows(), n = A.cols();
  double best = std::numeric_limits<double>::infinity();
  for (unsigned subset = 0; subset < (1U << n); ++subset) {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index j = 0; j < n; ++j) {
      if ((subset >> j & 1U) != 0) columns.push_back(j);
    }
    if (static_cast<Eigen::Index>(columns.size()) != m) continue;
    const Eigen::FullPivLU<MatrixXd> lu(A(Eigen::all, columns));
    if (lu.isInvertible()) best = std::min(best, lu.solve(y).cwiseAbs().sum());
  }
  return best;
}

/// Eq. 11 cell by cell.
inline double total_variation(const std::vector<double>& map, std::size_t width) {
  double sum = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double down = i >= width ? map[i] - map[i - width] : 0.0;
    const double across = i % width > 0 ? map[i] - map[i - 1] : 0.0;
    sum += std::sqrt(down * down + across * across);
  }
  return sum;
}

}  // namespace cogslam::slow
