#include "slam/recover/kalman_prior.hpp"

#include <Eigen/Cholesky>

#include "core/check.hpp"

namespace cogslam {

KalmanEstimate kalman_step(const MapView& a, std::span<const double> y, double measurement_variance,
                           double process_variance) {
  EXPECTS(y.size() == a.rows());
  EXPECTS(measurement_variance > 0.0 && process_variance >= 0.0);
  const double prior = 1.0 + process_variance;
  const Eigen::MatrixXd H = explicit_matrix(a);
  const Eigen::Map<const Eigen::VectorXd> b(y.data(), static_cast<Eigen::Index>(y.size()));
  Eigen::MatrixXd innovation = prior * (H * H.transpose());
  innovation.diagonal().array() += measurement_variance;
  const Eigen::LLT<Eigen::MatrixXd> factor(innovation);
  KalmanEstimate estimate{prior * (H.transpose() * factor.solve(b)),
                          -(prior * prior) * (H.transpose() * factor.solve(H))};
  estimate.covariance.diagonal().array() += prior;
  return estimate;
}

void apply_pseudo_measurement(KalmanEstimate& estimate, const Eigen::VectorXd& h, double value, double variance,
                              Eigen::VectorXd& scratch) {
  auto covariance = estimate.covariance.selfadjointView<Eigen::Lower>();
  scratch.noalias() = covariance * h;
  const double innovation = h.dot(scratch) + variance;
  estimate.mean.noalias() -= (value / innovation) * scratch;
  covariance.rankUpdate(scratch, -1.0 / innovation);
}

Recovered recovered_mean(const KalmanEstimate& estimate, const MapView& a, std::span<const double> y, int iterations) {
  Recovered result{.x = {estimate.mean.begin(), estimate.mean.end()},
                   // The paper's loop has a fixed length: it ends well if the numbers stayed finite.
                   .converged = estimate.mean.allFinite(),
                   .iterations = iterations};
  result.residual = residual_norm(a, result.x, y);
  return result;
}

}  // namespace cogslam
