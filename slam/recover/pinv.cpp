#include "slam/recover/pinv.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/check.hpp"

namespace cogslam {

Recovered recover(const PseudoInverse& pinv, const MapView& a, std::span<const double> y) {
  EXPECTS(y.size() == a.rows());
  if (y.empty()) return {.x = std::vector<double>(a.cols(), 0.0), .converged = true};
  const Eigen::MatrixXd matrix = explicit_matrix(a);
  const Eigen::Map<const Eigen::VectorXd> b(y.data(), static_cast<Eigen::Index>(y.size()));
  Eigen::VectorXd x;
  if (pinv.decomposition == PseudoInverse::Decomposition::kSvd) {
    x = matrix.bdcSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(b);
  } else {
    x = matrix.completeOrthogonalDecomposition().solve(b);
  }
  Recovered result{.x = {x.begin(), x.end()}, .converged = x.allFinite(), .iterations = 1};
  result.residual = residual_norm(a, result.x, y);
  return result;
}

}  // namespace cogslam
