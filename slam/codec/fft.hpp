#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace cogslam {

/// Complex discrete Fourier transform of any length, X_k = sum_j x_j e^(-2 pi i j k / n); n log n for any n.
/// Lengths of small prime factors by Eigen's kissfft, which never asks what processor it runs on, so that results are
/// the same on all; others as a convolution of a power of two (Bluestein 1970). Allocates at construction only.
class Fft {
 public:
  using Complex = std::complex<double>;

  explicit Fft(std::size_t length);
  ~Fft();
  Fft(const Fft& other);
  Fft& operator=(const Fft& other);
  Fft(Fft&&) noexcept;
  Fft& operator=(Fft&&) noexcept;

  [[nodiscard]] std::size_t length() const { return length_; }
  /// `in`, `out`: n values; they may not overlap.
  void forward(std::span<const Complex> in, std::span<Complex> out);

 private:
  struct Plan;
  std::size_t length_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace cogslam
