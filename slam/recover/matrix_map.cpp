#include "slam/recover/matrix_map.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "core/check.hpp"

namespace cogslam {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMajor> matrix_of(const MatrixMap& map) {
  return {map.entries().data(), static_cast<Eigen::Index>(map.rows()), static_cast<Eigen::Index>(map.cols())};
}

Eigen::Map<const Eigen::VectorXd> vector_of(std::span<const double> x) {
  return {x.data(), static_cast<Eigen::Index>(x.size())};
}

Eigen::Map<Eigen::VectorXd> vector_of(std::span<double> x) { return {x.data(), static_cast<Eigen::Index>(x.size())}; }

bool rows_are_orthonormal(const MatrixMap& map) {
  if (map.rows() > map.cols()) return false;
  Eigen::MatrixXd gram = matrix_of(map) * matrix_of(map).transpose();
  gram.diagonal().array() -= 1.0;
  return gram.cwiseAbs().maxCoeff() <= 1e-10;
}

bool rows_are_units(const MatrixMap& map) {
  for (std::size_t i = 0; i < map.rows(); ++i) {
    const std::span<const double> row = map.entries().subspan(i * map.cols(), map.cols());
    const auto zeros = static_cast<std::size_t>(std::count(row.begin(), row.end(), 0.0));
    if (zeros + 1 != row.size() || std::count(row.begin(), row.end(), 1.0) != 1) return false;
  }
  return true;
}

}  // namespace

MatrixMap::MatrixMap(std::vector<double> entries, std::size_t rows, std::size_t cols)
    : entries_(std::move(entries)), rows_(rows), cols_(cols) {
  EXPECTS(rows_ > 0 && cols_ > 0 && entries_.size() == rows_ * cols_);
  orthonormal_rows_ = rows_are_orthonormal(*this);
  is_selection_ = rows_are_units(*this);
}

void MatrixMap::apply(std::span<const double> x, std::span<double> out) const {
  EXPECTS(x.size() == cols_ && out.size() == rows_);
  vector_of(out).noalias() = matrix_of(*this) * vector_of(x);
}

void MatrixMap::apply_transpose(std::span<const double> y, std::span<double> out) const {
  EXPECTS(y.size() == rows_ && out.size() == cols_);
  vector_of(out).noalias() = matrix_of(*this).transpose() * vector_of(y);
}

}  // namespace cogslam
