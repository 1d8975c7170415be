#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "slam/codec/haar.hpp"

namespace cogslam {

/// The 2-D non-standard Haar basis of haar.hpp, with its scratch memory.
class HaarBasis {
 public:
  HaarBasis(int width, int height);

  [[nodiscard]] std::size_t cells() const { return canvas_.cells(); }
  [[nodiscard]] std::size_t size() const { return canvas_.size(); }
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);

 private:
  HaarCanvas canvas_;
  std::vector<double> scratch_;
};

/// Full-depth 1-D Haar on vec(M), the length padded with zeros to a power of two.
/// Layout [mean | coarsest detail | ... | finest details]; details are (a - b) / sqrt2.
class Haar1dBasis {
 public:
  explicit Haar1dBasis(std::size_t length);

  [[nodiscard]] std::size_t cells() const { return length_; }
  [[nodiscard]] std::size_t size() const { return canvas_.size(); }
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);

 private:
  std::size_t length_;
  std::vector<double> canvas_;
  std::vector<double> scratch_;
};

/// 2-D standard Haar: the 1-D transform at full depth of every row, then of every column; sides padded with zeros to
/// powers of two. Coefficients row-major.
class HaarStandardBasis {
 public:
  HaarStandardBasis(std::size_t width, std::size_t height);

  [[nodiscard]] std::size_t cells() const { return map_width_ * map_height_; }
  [[nodiscard]] std::size_t size() const { return width_ * height_; }
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);

 private:
  std::size_t map_width_, map_height_;
  std::size_t width_, height_;
  std::vector<double> canvas_;
  std::vector<double> scratch_;
};

}  // namespace cogslam
