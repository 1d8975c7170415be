#pragma once

#include <algorithm>
#include <cmath>

namespace cogslam {

/// argmin_u |u| threshold + (u - x)^2 / 2: x moved towards zero by the threshold, not past it.
inline double soft_threshold(double x, double threshold) {
  return std::copysign(std::max(std::abs(x) - threshold, 0.0), x);
}

/// |x| made smooth by a parabola of curvature 1/mu within [-mu, mu] (Huber); |x| - mu/2 <= huber(x) <= |x|. mu > 0.
inline double huber(double x, double mu) {
  const double size = std::abs(x);
  return size < mu ? x * x / (2.0 * mu) : size - 0.5 * mu;
}

/// Derivative of huber: x/mu, clipped to [-1, 1].
inline double huber_gradient(double x, double mu) { return x / std::max(mu, std::abs(x)); }

/// The paper's sign, eq. (48): +1 at zero.
inline double sign_plus(double x) { return x >= 0.0 ? 1.0 : -1.0; }

}  // namespace cogslam
