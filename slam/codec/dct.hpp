#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "slam/codec/fft.hpp"

namespace cogslam {

/// Orthonormal DCT-II of lines of any length n,
///   c_k = s_k sum_j x_j cos(pi (2j+1) k / 2n), s_0 = sqrt(1/n), s_k = sqrt(2/n),
/// and its inverse (Makhoul 1980): two lines at a time by one complex FFT of length n, a single line of even length by
/// one of n/2.
class DctLines {
 public:
  explicit DctLines(std::size_t length);

  [[nodiscard]] std::size_t length() const { return length_; }
  /// Transforms `count` lines; value j of line i is at i * line_step + j * step, in `in` and `out` alike; in may be
  /// out.
  void forward(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step);
  void inverse(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step);

 private:
  using Complex = std::complex<double>;
  using Pair = void (DctLines::*)(const double* a, const double* b, double* to_a, double* to_b);
  using One = void (DctLines::*)(const double* in, double* out);

  void forward_pair(const double* a, const double* b, double* to_a, double* to_b);
  void inverse_pair(const double* a, const double* b, double* to_a, double* to_b);
  void forward_one(const double* in, double* out);
  void inverse_one(const double* in, double* out);
  void whole_lines(Pair pair, One one, const double* in, double* out, std::size_t count, std::size_t line_step);
  void all_lines(Pair pair, One one, const double* in, double* out, std::size_t count, std::size_t line_step,
                 std::size_t step);

  std::size_t length_;
  Fft fft_;
  std::optional<Fft> half_;         ///< of even lengths
  std::vector<Complex> turn_;       ///< e^(i pi k / 2n) / sqrt(2n), k <= n/2
  std::vector<Complex> half_turn_;  ///< e^(-2 pi i k / n), k <= n/2
  std::vector<Complex> in_, out_;
  std::vector<double> block_;  ///< lines that were not whole, side by side
};

/// DCT-II of vec(M), or of a signal.
class Dct1d {
 public:
  explicit Dct1d(std::size_t length) : lines_(length) {}

  [[nodiscard]] std::size_t cells() const { return lines_.length(); }
  [[nodiscard]] std::size_t size() const { return lines_.length(); }
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);

 private:
  DctLines lines_;
};

/// Separable 2-D DCT-II: along x, then along y. Coefficient (row, column), row-major, has `column` half waves along x.
class Dct2d {
 public:
  Dct2d(std::size_t width, std::size_t height) : along_x_(width), along_y_(height) {}

  [[nodiscard]] std::size_t cells() const { return along_x_.length() * along_y_.length(); }
  [[nodiscard]] std::size_t size() const { return cells(); }
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);

 private:
  DctLines along_x_;
  DctLines along_y_;
};

}  // namespace cogslam
