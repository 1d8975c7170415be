#include "slam/codec/haar_basis.hpp"

#include <algorithm>
#include <bit>
#include <numbers>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kScale = 1.0 / std::numbers::sqrt2;

/// All levels along a column of `count` entries, a power of two, each of `block` values next to each other: 1 for a
/// row of cells, the width for all columns of an image at once.
void split_all(double* data, std::size_t count, std::size_t block, double* scratch) {
  for (std::size_t length = count; length > 1; length /= 2) {
    double* detail = scratch + length / 2 * block;
    for (std::size_t i = 0; i < length / 2; ++i) {
      const double* a = data + 2 * i * block;
      const double* b = a + block;
      for (std::size_t j = 0; j < block; ++j) {
        scratch[i * block + j] = kScale * (a[j] + b[j]);
        detail[i * block + j] = kScale * (a[j] - b[j]);
      }
    }
    std::copy_n(scratch, length * block, data);
  }
}

void join_all(double* data, std::size_t count, std::size_t block, double* scratch) {
  for (std::size_t length = 2; length <= count; length *= 2) {
    const double* detail = data + length / 2 * block;
    for (std::size_t i = 0; i < length / 2; ++i) {
      double* a = scratch + 2 * i * block;
      double* b = a + block;
      for (std::size_t j = 0; j < block; ++j) {
        a[j] = kScale * (data[i * block + j] + detail[i * block + j]);
        b[j] = kScale * (data[i * block + j] - detail[i * block + j]);
      }
    }
    std::copy_n(scratch, length * block, data);
  }
}

}  // namespace

HaarBasis::HaarBasis(int width, int height)
    : canvas_(HaarCanvas::covering(width, height)), scratch_(canvas_.scratch_size()) {}

void HaarBasis::forward(std::span<const double> values, std::span<double> coefficients) {
  haar_forward(canvas_, values, coefficients, scratch_);
}

void HaarBasis::inverse(std::span<const double> coefficients, std::span<double> values) {
  haar_inverse(canvas_, coefficients, values, scratch_);
}

Haar1dBasis::Haar1dBasis(std::size_t length)
    : length_(length), canvas_(std::bit_ceil(length)), scratch_(canvas_.size()) {
  EXPECTS(length > 0);
}

void Haar1dBasis::forward(std::span<const double> values, std::span<double> coefficients) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  const auto padding = std::copy(values.begin(), values.end(), coefficients.begin());
  std::fill(padding, coefficients.end(), 0.0);
  split_all(coefficients.data(), size(), 1, scratch_.data());
}

void Haar1dBasis::inverse(std::span<const double> coefficients, std::span<double> values) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  std::copy(coefficients.begin(), coefficients.end(), canvas_.begin());
  join_all(canvas_.data(), size(), 1, scratch_.data());
  std::copy_n(canvas_.begin(), length_, values.begin());
}

HaarStandardBasis::HaarStandardBasis(std::size_t width, std::size_t height)
    : map_width_(width),
      map_height_(height),
      width_(std::bit_ceil(width)),
      height_(std::bit_ceil(height)),
      canvas_(width_ * height_),
      scratch_(width_ * height_) {
  EXPECTS(width > 0 && height > 0);
}

void HaarStandardBasis::forward(std::span<const double> values, std::span<double> coefficients) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  std::fill(coefficients.begin(), coefficients.end(), 0.0);
  for (std::size_t y = 0; y < map_height_; ++y) {
    double* row = coefficients.data() + y * width_;
    std::copy_n(values.data() + y * map_width_, map_width_, row);
    split_all(row, width_, 1, scratch_.data());
  }
  split_all(coefficients.data(), height_, width_, scratch_.data());
}

void HaarStandardBasis::inverse(std::span<const double> coefficients, std::span<double> values) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  std::copy(coefficients.begin(), coefficients.end(), canvas_.begin());
  join_all(canvas_.data(), height_, width_, scratch_.data());
  for (std::size_t y = 0; y < map_height_; ++y) {
    double* row = canvas_.data() + y * width_;
    join_all(row, width_, 1, scratch_.data());
    std::copy_n(row, map_width_, values.data() + y * map_width_);
  }
}

}  // namespace cogslam
