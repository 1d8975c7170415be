#pragma once

#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// Kalman filter constrained by the quasi-norm (sum |c|^p)^(1/p) (CSEKF-p, sec. 4.4, Alg. 6).
///
/// As printed the algorithm contradicts itself: line 14 overwrites the derivative, so that p would have no effect, the
/// exponent in eq. 57 is not that of the derivative, and line 16 differs from eq. 58. Line 14 is left out here, the
/// mean moves by eq. 58, and the rest is a choice of reading. The loop is chaotic: rounding decides single coefficients
/// after some ten passes, so only errors averaged over many signals mean anything.
struct KalmanCsP {
  enum class Reading {
    kAsPrinted,     ///< R1: derivative as eq. 57 prints it, S^(1/(p-1)) |c|^(p-1); shows the paper's results
    kTrueGradient,  ///< R2: derivative S^(1/p-1) |c|^(p-1), which needs P = 1e8; most accurate from few data
    kPowerSum,      ///< R3: constrains S = sum |c|^p itself, derivative p |c|^(p-1)
  };
  Reading reading = Reading::kAsPrinted;
  double p = 0.4;                             ///< in (0, 1)
  double measurement_variance = 0.01 * 0.01;  ///< Q > 0, squared units of y
  double process_variance = 0.0;              ///< R >= 0
  double norm_variance = 100.0 * 100.0;       ///< P > 0
  int tau = 1000;                             ///< >= 1; the printed loop makes tau - 1 passes
  double floor = 1e-3;                        ///< |c| counts as at least this in |c|^(p-1), which has a pole at 0; > 0

  /// The paper's parameters, with the P that the reading needs.
  static KalmanCsP of(Reading reading);
};

/// `y`: a.rows() values.
[[nodiscard]] Recovered recover(const KalmanCsP& csekf_p, const MapView& a, std::span<const double> y);

}  // namespace cogslam
