#include "slam/recover/kalman_cs_p.hpp"

#include <cmath>

#include "core/check.hpp"
#include "slam/recover/kalman_prior.hpp"
#include "slam/recover/shrink.hpp"

namespace cogslam {
namespace {

using Reading = KalmanCsP::Reading;

/// Factor of |c|^(p-1) in the derivative.
double derivative_scale(Reading reading, double power_sum, double p) {
  switch (reading) {
    case Reading::kAsPrinted:
      return std::pow(power_sum, 1.0 / (p - 1.0));
    case Reading::kTrueGradient:
      return std::pow(power_sum, 1.0 / p - 1.0);
    case Reading::kPowerSum:
      return p;
  }
  return 0.0;
}

}  // namespace

KalmanCsP KalmanCsP::of(Reading reading) {
  KalmanCsP parameters{.reading = reading};
  if (reading == Reading::kTrueGradient) parameters.norm_variance = 1e8;
  return parameters;
}

Recovered recover(const KalmanCsP& csekf_p, const MapView& a, std::span<const double> y) {
  const double p = csekf_p.p;
  EXPECTS(p > 0.0 && p < 1.0 && csekf_p.norm_variance > 0.0 && csekf_p.tau >= 1 && csekf_p.floor > 0.0);
  KalmanEstimate estimate = kalman_step(a, y, csekf_p.measurement_variance, csekf_p.process_variance);
  Eigen::VectorXd h(estimate.mean.size());
  Eigen::VectorXd scratch(estimate.mean.size());
  int passes = 0;
  while (passes < csekf_p.tau - 1 && estimate.mean.allFinite()) {
    const double power_sum =
        estimate.mean.unaryExpr([p](double c) { return c == 0.0 ? 0.0 : std::pow(std::abs(c), p); }).sum();
    // At c = 0 the constraint holds already, and (57) as printed would divide by zero.
    if (power_sum == 0.0) break;
    const double scale = derivative_scale(csekf_p.reading, power_sum, p);
    h = estimate.mean.unaryExpr([&](double c) {  // (57)
      return sign_plus(c) * scale * std::pow(std::max(std::abs(c), csekf_p.floor), p - 1.0);
    });
    const double value = csekf_p.reading == Reading::kPowerSum ? power_sum : std::pow(power_sum, 1.0 / p);
    apply_pseudo_measurement(estimate, h, value, csekf_p.norm_variance, scratch);  // (56), (58), (59)
    ++passes;
  }
  return recovered_mean(estimate, a, y, passes);
}

}  // namespace cogslam
