#pragma once

#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// Compressed sensing embedded Kalman filter (CSEKF, sec. 4.3, Alg. 5): one Kalman step, then tau - 1 pseudo-
/// measurements that the l1 norm be zero. Memory n^2, time tau n^2. Works for any map. Scaled data give
/// the scaled answer, as only the signs enter the gains; scaled variances do not.
struct KalmanCs {
  double measurement_variance = 0.01 * 0.01;  ///< Q > 0, squared units of y
  double process_variance = 0.0;              ///< R >= 0
  double norm_variance = 100.0 * 100.0;       ///< P > 0: how loosely the norm is held to zero
  int tau = 1000;                             ///< >= 1; the printed loop makes tau - 1 passes
};

/// `y`: a.rows() values.
[[nodiscard]] Recovered recover(const KalmanCs& csekf, const MapView& a, std::span<const double> y);

}  // namespace cogslam
