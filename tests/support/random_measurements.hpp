#pragma once

#include <Eigen/QR>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/rng.hpp"
#include "slam/recover/matrix_map.hpp"

/// Small measurement problems for tests of recoveries; everything follows from the Rng that is handed in.
namespace cogslam::test {

inline Rng rng_of(std::uint32_t seed) { return Rng({seed, Purpose::kCompression, 77, 0}); }

inline Eigen::MatrixXd normal_matrix(Eigen::Index rows, Eigen::Index cols, Rng& rng) {
  Eigen::MatrixXd matrix(rows, cols);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < cols; ++j) matrix(i, j) = rng.normal();
  }
  return matrix;
}

/// Uniformly distributed (Haar) orthogonal matrix: QR of a Gaussian one, signs fixed by the diagonal of R.
inline Eigen::MatrixXd orthogonal_matrix(Eigen::Index n, Rng& rng) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(normal_matrix(n, n, rng));
  Eigen::MatrixXd q = qr.householderQ();
  for (Eigen::Index j = 0; j < n; ++j) {
    if (qr.matrixQR()(j, j) < 0.0) q.col(j) = -q.col(j);
  }
  return q;
}

inline MatrixMap map_of(const Eigen::MatrixXd& matrix) {
  std::vector<double> entries;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) entries.push_back(matrix(i, j));
  }
  return {std::move(entries), static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())};
}

/// `m` distinct entries of `n`, in random order.
inline std::vector<std::size_t> random_entries(std::size_t m, std::size_t n, Rng& rng) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < m; ++i) {
    std::swap(order[i], order[i + rng.below(static_cast<std::uint32_t>(n - i))]);
  }
  order.resize(m);
  return order;
}

inline MatrixMap selection_of(std::span<const std::size_t> entries, std::size_t n) {
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(entries.size()), static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(entries[i])) = 1.0;
  }
  return map_of(matrix);
}

inline std::vector<double> normal_vector(std::size_t n, Rng& rng) {
  std::vector<double> x(n);
  for (double& value : x) value = rng.normal();
  return x;
}

/// `k` entries normal with standard deviation 3, the others 0.
inline std::vector<double> sparse_vector(std::size_t n, std::size_t k, Rng& rng) {
  std::vector<double> x(n, 0.0);
  for (const std::size_t i : random_entries(k, n, rng)) x[i] = 3.0 * rng.normal();
  return x;
}

inline std::vector<double> measured(const MatrixMap& a, std::span<const double> x) {
  std::vector<double> y(a.rows());
  a.apply(x, y);
  return y;
}

inline double l1_norm(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0.0, [](double sum, double v) { return sum + std::abs(v); });
}

inline double squared_distance(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

inline double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return a.size() == b.size() ? largest : HUGE_VAL;
}

inline std::vector<double> operator_times(const Eigen::MatrixXd& matrix, std::span<const double> x) {
  const Eigen::VectorXd out = matrix * Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  return {out.begin(), out.end()};
}

}  // namespace cogslam::test
