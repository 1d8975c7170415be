#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "slam/codec/fft.hpp"

namespace cogslam {

/// Orthonormal DCT-II of lines of any length n,
///   c_k = s_k sum_j x_j cos(pi (2j+1) k / 2n), s_0 = sqrt(1/n), s_k = sqrt(2/n),
/// and its inverse, by one complex FFT of length n for two lines at a time (Makhoul 1980).
class DctLines {
 public:
  explicit DctLines(std::size_t length);

  [[nodiscard]] std::size_t length() const { return fft_.length(); }
  /// Transforms `count` lines; value j of line i is at i * line_step + j * step, in `in` and `out` alike; in may be
  /// out.
  void forward(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step);
  void inverse(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step);

 private:
  struct Pair;  // two lines, the parts of complex ones
  [[nodiscard]] std::size_t shuffled(std::size_t j) const;
  void forward(const Pair& pair, std::size_t step);
  void inverse(const Pair& pair, std::size_t step);

  Fft fft_;
  std::vector<std::complex<double>> turn_;  ///< e^(i pi k / 2n)
  std::vector<double> scale_;               ///< s_k
  std::vector<std::complex<double>> in_, out_;
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
