#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cogslam {

/// Fast Walsh-Hadamard transform in place: values <- H_n values / sqrt(n), with H_2n = [H_n H_n; H_n -H_n] (Sylvester,
/// natural order): H_n(j, k) = (-1)^popcount(j & k). Its own inverse. `values`: n, a power of two.
void walsh_hadamard(std::span<double> values);

/// Walsh-Hadamard on a map, both sides padded with zeros to powers of two. On row-major data the 1-D transform of all
/// values is the 2-D one: H_(hw) = H_h (x) H_w.
class HadamardBasis {
 public:
  HadamardBasis(std::size_t width, std::size_t height);

  [[nodiscard]] std::size_t cells() const { return map_width_ * map_height_; }
  [[nodiscard]] std::size_t size() const { return width_ * height_; }
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);

 private:
  std::size_t map_width_, map_height_;
  std::size_t width_, height_;
  std::vector<double> canvas_;
};

}  // namespace cogslam
