#include "slam/codec/hadamard.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

/// Two steps at once, which halves the walks through memory: parts of `h` values with 4 h between their groups.
void two_steps(std::span<double> values, std::size_t h) {
  for (std::size_t group = 0; group < values.size(); group += 4 * h) {
    double* a = values.data() + group;
    double *b = a + h, *c = b + h, *d = c + h;
    for (std::size_t i = 0; i < h; ++i) {
      const double ab = a[i] + b[i], a_b = a[i] - b[i];
      const double cd = c[i] + d[i], c_d = c[i] - d[i];
      a[i] = ab + cd;
      b[i] = a_b + c_d;
      c[i] = ab - cd;
      d[i] = a_b - c_d;
    }
  }
}

void last_step(std::span<double> values) {
  const std::size_t half = values.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const double a = values[i], b = values[half + i];
    values[i] = a + b;
    values[half + i] = a - b;
  }
}

}  // namespace

void walsh_hadamard(std::span<double> values) {
  EXPECTS(std::has_single_bit(values.size()));
  std::size_t h = 1;
  for (; 4 * h <= values.size(); h *= 4) two_steps(values, h);
  if (h < values.size()) last_step(values);
  const double scale = 1.0 / std::sqrt(static_cast<double>(values.size()));
  for (double& value : values) value *= scale;
}

HadamardBasis::HadamardBasis(std::size_t width, std::size_t height)
    : map_width_(width),
      map_height_(height),
      width_(std::bit_ceil(width)),
      height_(std::bit_ceil(height)),
      canvas_(width_ * height_) {
  EXPECTS(width > 0 && height > 0);
}

void HadamardBasis::forward(std::span<const double> values, std::span<double> coefficients) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  std::fill(coefficients.begin(), coefficients.end(), 0.0);
  for (std::size_t y = 0; y < map_height_; ++y) {
    std::copy_n(values.data() + y * map_width_, map_width_, coefficients.data() + y * width_);
  }
  walsh_hadamard(coefficients);
}

void HadamardBasis::inverse(std::span<const double> coefficients, std::span<double> values) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  std::copy(coefficients.begin(), coefficients.end(), canvas_.begin());
  walsh_hadamard(canvas_);
  for (std::size_t y = 0; y < map_height_; ++y) {
    std::copy_n(canvas_.data() + y * width_, map_width_, values.data() + y * map_width_);
  }
}

}  // namespace cogslam
