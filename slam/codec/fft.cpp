#include "slam/codec/fft.hpp"

#include <bit>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "core/check.hpp"

namespace cogslam {
namespace {

using Complex = Fft::Complex;

// A prime factor p costs n p. From here on two transforms of twice to four times the length are faster.
constexpr std::size_t kLargestDirectFactor = 17;

std::size_t largest_prime_factor(std::size_t n) {
  std::size_t largest = 1;
  for (std::size_t p = 2; p * p <= n; ++p) {
    for (; n % p == 0; n /= p) largest = p;
  }
  return std::max(largest, n);
}

// Spelled out: the operator of std::complex also looks after infinities, which takes longer than the product.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

struct Fft::Plan {
  explicit Plan(std::size_t n);
  void direct(const Complex* in, Complex* out, std::size_t n) { fft.fwd(out, in, static_cast<Eigen::Index>(n)); }
  void by_convolution(std::span<const Complex> in, std::span<Complex> out);

  Eigen::FFT<double> fft{Eigen::default_fft_impl<double>(), Eigen::FFT<double>::Unscaled};
  std::vector<Complex> chirp;   ///< e^(-i pi k^2 / n); empty: direct
  std::vector<Complex> kernel;  ///< spectrum of the conjugate chirp, over its length
  std::vector<Complex> work, spectrum;
};

Fft::Plan::Plan(std::size_t n) {
  if (n == 1) return;
  if (largest_prime_factor(n) <= kLargestDirectFactor) {
    std::vector<Complex> zeros(n), out(n);
    direct(zeros.data(), out.data(), n);  // the first use makes the tables of a length
    return;
  }
  for (std::size_t k = 0; k < n; ++k) {  // k^2 modulo 2n, the period, keeps the angle exact
    const double angle = std::numbers::pi * static_cast<double>(k * k % (2 * n)) / static_cast<double>(n);
    chirp.emplace_back(std::cos(angle), -std::sin(angle));
  }
  const std::size_t length = std::bit_ceil(2 * n - 1);
  work.assign(length, 0.0);
  kernel.resize(length);
  spectrum.resize(length);
  for (std::size_t k = 0; k < n; ++k) {
    work[k] = std::conj(chirp[k]) / static_cast<double>(length);
    work[(length - k) % length] = work[k];
  }
  direct(work.data(), kernel.data(), length);
}

/// j k = (j^2 + k^2 - (k-j)^2) / 2 makes the sum a convolution with the chirp.
void Fft::Plan::by_convolution(std::span<const Complex> in, std::span<Complex> out) {
  const std::size_t n = in.size();
  for (std::size_t j = 0; j < n; ++j) work[j] = product(in[j], chirp[j]);
  std::fill(work.begin() + static_cast<std::ptrdiff_t>(n), work.end(), 0.0);
  direct(work.data(), spectrum.data(), work.size());
  // The inverse transform is the conjugate of the transform of the conjugate.
  for (std::size_t k = 0; k < work.size(); ++k) spectrum[k] = std::conj(product(spectrum[k], kernel[k]));
  direct(spectrum.data(), work.data(), work.size());
  for (std::size_t k = 0; k < n; ++k) out[k] = product(std::conj(work[k]), chirp[k]);
}

Fft::Fft(std::size_t length) : length_(length) {
  EXPECTS(length > 0);
  plan_ = std::make_unique<Plan>(length);
}

Fft::~Fft() = default;
Fft::Fft(Fft&&) noexcept = default;
Fft& Fft::operator=(Fft&&) noexcept = default;

// A plan holds tables of its length and scratch memory, nothing that outlives a call.
Fft::Fft(const Fft& other) : Fft(other.length_) {}
Fft& Fft::operator=(const Fft& other) { return *this = Fft(other.length_); }

void Fft::forward(std::span<const Complex> in, std::span<Complex> out) {
  EXPECTS(in.size() == length_ && out.size() == length_);
  if (length_ == 1) {
    out[0] = in[0];
  } else if (plan_->chirp.empty()) {
    plan_->direct(in.data(), out.data(), length_);
  } else {
    plan_->by_convolution(in, out);
  }
}

}  // namespace cogslam
