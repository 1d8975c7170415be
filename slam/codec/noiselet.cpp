#include "slam/codec/noiselet.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

/// x <- x times [1 i; i 1] for each bit: entry (j, k) of the product is i^d(j,k). Parts apart, for vector units.
void turn_by_distance(std::span<double> real, std::span<double> imaginary) {
  for (std::size_t h = 1; h < real.size(); h *= 2) {
    for (std::size_t group = 0; group < real.size(); group += 2 * h) {
      double* __restrict a_re = real.data() + group, * __restrict a_im = imaginary.data() + group;
      double* __restrict b_re = a_re + h, * __restrict b_im = a_im + h;
      for (std::size_t i = 0; i < h; ++i) {
        const double re = a_re[i] - b_im[i], im = a_im[i] + b_re[i];
        b_re[i] -= a_im[i];
        b_im[i] += a_re[i];
        a_re[i] = re;
        a_im[i] = im;
      }
    }
  }
}

}  // namespace

Noiselets::Noiselets(std::size_t length) : real_(length), imaginary_(length) { EXPECTS(std::has_single_bit(length)); }

void Noiselets::forward(std::span<const double> values, std::span<double> out) {
  EXPECTS(values.size() == length() && out.size() == length());
  const std::size_t n = length();
  std::copy(values.begin(), values.end(), real_.begin());
  std::fill(imaginary_.begin(), imaginary_.end(), 0.0);
  turn_by_distance(real_, imaginary_);
  if (n == 1) {
    out[0] = values[0];
    return;
  }
  const double scale = 1.0 / std::sqrt(static_cast<double>(n));
  for (std::size_t j = 0; j < n / 2; ++j) {  // sqrt2 e^(i pi/4) = 1 + i
    out[j] = scale * (real_[j] - imaginary_[j]);
    out[n - 1 - j] = scale * (real_[j] + imaginary_[j]);
  }
}

void Noiselets::inverse(std::span<const double> coefficients, std::span<double> out) {
  EXPECTS(coefficients.size() == length() && out.size() == length());
  const std::size_t n = length();
  if (n == 1) {
    out[0] = coefficients[0];
    return;
  }
  // sum_j a_j Re(u_j) + b_j Im(u_j) = Re(sum_j (a_j - i b_j) u_j), and the matrix of the u_j is symmetric.
  for (std::size_t j = 0; j < n / 2; ++j) {
    real_[j] = coefficients[j];
    imaginary_[j] = -coefficients[n - 1 - j];
    real_[n - 1 - j] = imaginary_[n - 1 - j] = 0.0;
  }
  turn_by_distance(real_, imaginary_);
  const double scale = 1.0 / std::sqrt(static_cast<double>(n));
  for (std::size_t k = 0; k < n; ++k) out[k] = scale * (real_[k] - imaginary_[k]);
}

}  // namespace cogslam
