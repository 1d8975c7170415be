#include "slam/recover/map_view.hpp"

#include <cmath>
#include <vector>

namespace cogslam {

Eigen::MatrixXd explicit_matrix(const MapView& a) {
  std::vector<double> unit(a.rows(), 0.0);
  std::vector<double> row(a.cols());
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(a.rows()), static_cast<Eigen::Index>(a.cols()));
  for (std::size_t i = 0; i < a.rows(); ++i) {
    unit[i] = 1.0;
    a.apply_transpose(unit, row);
    matrix.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
    unit[i] = 0.0;
  }
  return matrix;
}

double residual_norm(const MapView& a, std::span<const double> x, std::span<const double> y) {
  std::vector<double> ax(a.rows());
  a.apply(x, ax);
  double sum = 0.0;
  for (std::size_t i = 0; i < ax.size(); ++i) sum += (ax[i] - y[i]) * (ax[i] - y[i]);
  return std::sqrt(sum);
}

}  // namespace cogslam
