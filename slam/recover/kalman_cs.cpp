#include "slam/recover/kalman_cs.hpp"

#include "core/check.hpp"
#include "slam/recover/kalman_prior.hpp"
#include "slam/recover/shrink.hpp"

namespace cogslam {

Recovered recover(const KalmanCs& csekf, const MapView& a, std::span<const double> y) {
  EXPECTS(csekf.norm_variance > 0.0 && csekf.tau >= 1);
  KalmanEstimate estimate = kalman_step(a, y, csekf.measurement_variance, csekf.process_variance);
  Eigen::VectorXd h(estimate.mean.size());
  Eigen::VectorXd scratch(estimate.mean.size());
  for (int pass = 1; pass < csekf.tau; ++pass) {
    h = estimate.mean.unaryExpr([](double c) { return sign_plus(c); });                         // (48)
    apply_pseudo_measurement(estimate, h, h.dot(estimate.mean), csekf.norm_variance, scratch);  // (49)-(51)
  }
  return recovered_mean(estimate, a, y, csekf.tau - 1);
}

}  // namespace cogslam
