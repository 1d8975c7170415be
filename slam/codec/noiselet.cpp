#include "slam/codec/noiselet.hpp"

#include <bit>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

/// work <- work times [1 i; i 1] for each bit: entry (j, k) of the product is i^d(j,k).
void turn_by_distance(std::span<std::complex<double>> work) {
  for (std::size_t h = 1; h < work.size(); h *= 2) {
    for (std::size_t group = 0; group < work.size(); group += 2 * h) {
      for (std::size_t i = group; i < group + h; ++i) {
        const std::complex<double> a = work[i], b = work[i + h];
        work[i] = {a.real() - b.imag(), a.imag() + b.real()};
        work[i + h] = {b.real() - a.imag(), b.imag() + a.real()};
      }
    }
  }
}

}  // namespace

Noiselets::Noiselets(std::size_t length) : work_(length) { EXPECTS(std::has_single_bit(length)); }

void Noiselets::forward(std::span<const double> values, std::span<double> out) {
  EXPECTS(values.size() == length() && out.size() == length());
  const std::size_t n = length();
  for (std::size_t k = 0; k < n; ++k) work_[k] = values[k];
  turn_by_distance(work_);
  if (n == 1) {
    out[0] = values[0];
    return;
  }
  const double scale = 1.0 / std::sqrt(static_cast<double>(n));
  for (std::size_t j = 0; j < n / 2; ++j) {  // sqrt2 e^(i pi/4) = 1 + i
    out[j] = scale * (work_[j].real() - work_[j].imag());
    out[n - 1 - j] = scale * (work_[j].real() + work_[j].imag());
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
    work_[j] = {coefficients[j], -coefficients[n - 1 - j]};
    work_[n - 1 - j] = 0.0;
  }
  turn_by_distance(work_);
  const double scale = 1.0 / std::sqrt(static_cast<double>(n));
  for (std::size_t k = 0; k < n; ++k) out[k] = scale * (work_[k].real() - work_[k].imag());
}

}  // namespace cogslam
