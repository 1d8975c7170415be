#include "slam/recover/fast_l2.hpp"

#include "core/check.hpp"

namespace cogslam {

Recovered recover(const FastL2& /*no parameters*/, const MapView& a, std::span<const double> y) {
  EXPECTS(y.size() == a.rows());
  EXPECTS(a.orthonormal_rows());
  Recovered result{.x = std::vector<double>(a.cols()), .converged = true, .iterations = 1};
  a.apply_transpose(y, result.x);
  // A A' = I, so A x = y; measuring it would cost as much again.
  result.residual = 0.0;
  return result;
}

}  // namespace cogslam
