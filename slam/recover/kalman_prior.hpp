#pragma once

#include <Eigen/Core>
#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// What both Kalman recoveries share: the estimate as a Gaussian, and the two steps that change it.
struct KalmanEstimate {
  Eigen::VectorXd mean;        ///< c-hat, n values
  Eigen::MatrixXd covariance;  ///< Sigma, n x n; only the lower triangle is kept up to date
};

/// Eqs. 39-43 from c = 0, Sigma = I, with A = I: the ordinary Kalman step that both recoveries start from.
/// `measurement_variance`: Q of eq. 41, > 0; `process_variance`: R of eq. 40, >= 0 (the paper swaps the usual letters).
[[nodiscard]] KalmanEstimate kalman_step(const MapView& a, std::span<const double> y, double measurement_variance,
                                         double process_variance);

/// One pseudo-measurement (eqs. 49-51 or 56, 58, 59): the constraint's value `value` should have been 0, its derivative
/// is `h`, its variance P. As a rank-one update: Sigma -= (Sigma h)(Sigma h)' / (h' Sigma h + P).
/// `scratch`: n values.
void apply_pseudo_measurement(KalmanEstimate& estimate, const Eigen::VectorXd& h, double value, double variance,
                              Eigen::VectorXd& scratch);

/// The estimate's mean as a solver's answer.
[[nodiscard]] Recovered recovered_mean(const KalmanEstimate& estimate, const MapView& a, std::span<const double> y,
                                       int iterations);

}  // namespace cogslam
