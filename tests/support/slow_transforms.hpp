#pragma once

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>

#include "slam/codec/basis.hpp"
#include "tests/support/slow_haar.hpp"

/// Orthonormal transforms as dense matrices from their definitions, coefficients = matrix * values.
namespace cogslam::slow {

inline Eigen::MatrixXd dct_matrix(int n) {
  Eigen::MatrixXd matrix(n, n);
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      matrix(k, j) = std::sqrt((k == 0 ? 1.0 : 2.0) / n) * std::cos(std::numbers::pi * (2 * j + 1) * k / (2.0 * n));
    }
  }
  return matrix;
}

inline Eigen::MatrixXd hadamard_matrix(int n) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Constant(1, 1, 1.0);
  while (matrix.rows() < n) {  // H_2n = [H H; H -H]
    const Eigen::Index m = matrix.rows();
    Eigen::MatrixXd twice(2 * m, 2 * m);
    twice << matrix, matrix, matrix, -matrix;
    matrix = twice;
  }
  return matrix / std::sqrt(static_cast<double>(n));
}

/// Real noiselets from the recursion of Coifman, Geshwind and Meyer, on samples: the first is constant, and
///   f_2k = ((1 - i) f_k(2x) + (1 + i) f_k(2x - 1)) / 2, f_2k+1 with the factors exchanged, normalised.
/// Which row is which, and its phase, are conventions: the rows here are in the recursion's own order.
inline Eigen::MatrixXcd complex_noiselets(int n) {
  using Complex = std::complex<double>;
  Eigen::MatrixXcd rows = Eigen::MatrixXcd::Constant(1, 1, 1.0);
  while (rows.rows() < n) {
    const Eigen::Index m = rows.rows();
    Eigen::MatrixXcd twice(2 * m, 2 * m);
    for (Eigen::Index k = 0; k < m; ++k) {
      twice.row(2 * k) << Complex(0.5, -0.5) * rows.row(k), Complex(0.5, 0.5) * rows.row(k);
      twice.row(2 * k + 1) << Complex(0.5, 0.5) * rows.row(k), Complex(0.5, -0.5) * rows.row(k);
    }
    rows = twice;
  }
  return rows;
}

/// n a power of two. Rows: the mean, then details from the coarsest; +, then - on halves of a block.
inline Eigen::MatrixXd haar_matrix(int n) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  matrix.row(0).setConstant(1.0 / std::sqrt(n));
  int row = 1;
  for (int block = n; block > 1; block /= 2) {
    for (int begin = 0; begin < n; begin += block, ++row) {
      matrix.row(row).segment(begin, block / 2).setConstant(1.0 / std::sqrt(block));
      matrix.row(row).segment(begin + block / 2, block / 2).setConstant(-1.0 / std::sqrt(block));
    }
  }
  return matrix;
}

/// (A (x) B): on row-major images, A acts along y and B along x.
inline Eigen::MatrixXd kronecker(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd product(a.rows() * b.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      product.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
    }
  }
  return product;
}

inline int power_of_two_from(int n) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(n))); }

/// Phi' of eq. (14) as size x cells: of a matrix on a padded canvas, the columns of the map's cells.
inline Eigen::MatrixXd basis_matrix(BasisKind kind, int width, int height) {
  const int w = power_of_two_from(width), h = power_of_two_from(height), cells = width * height;
  if (kind == BasisKind::kIdentity) return Eigen::MatrixXd::Identity(cells, cells);
  if (kind == BasisKind::kDct1d) return dct_matrix(cells);
  if (kind == BasisKind::kDct) return kronecker(dct_matrix(height), dct_matrix(width));
  if (kind == BasisKind::kHaar1d) return haar_matrix(power_of_two_from(cells)).leftCols(cells);
  Eigen::MatrixXd full(w * h, w * h);
  if (kind == BasisKind::kHadamard) full = kronecker(hadamard_matrix(h), hadamard_matrix(w));
  if (kind == BasisKind::kHaarStandard) full = kronecker(haar_matrix(h), haar_matrix(w));
  for (int c = 0; kind == BasisKind::kHaar && c < w * h; ++c) {
    const std::vector<double> image = haar_function(w, h, c % w, c / w);
    full.row(c) = Eigen::Map<const Eigen::RowVectorXd>(image.data(), w * h);
  }
  Eigen::MatrixXd of_map(w * h, cells);
  for (int cell = 0; cell < cells; ++cell) of_map.col(cell) = full.col(cell / width * w + cell % width);
  return of_map;
}

}  // namespace cogslam::slow
