#include "slam/codec/haar.hpp"

#include <algorithm>
#include <bit>
#include <numbers>

#include "core/check.hpp"

namespace cogslam {
namespace {

std::size_t product(int a, int b) { return static_cast<std::size_t>(a) * static_cast<std::size_t>(b); }

int log2_of(int power_of_two) { return std::countr_zero(static_cast<unsigned>(power_of_two)); }

/// What one step reads and writes: the extent of the finer image, and where its details lie on the canvas.
struct Step {
  std::size_t width;     // cells of the finer image along x
  std::size_t height;    // and along y
  std::size_t stride;    // of the canvas
  std::size_t to_right;  // offset of the column differences on the canvas
  std::size_t to_above;  // offset of the row differences on the canvas

  Step(const HaarCanvas& canvas, int level)
      : width(static_cast<std::size_t>(canvas.extent_x(level - 1))),
        height(static_cast<std::size_t>(canvas.extent_y(level - 1))),
        stride(static_cast<std::size_t>(canvas.width)),
        to_right(stride >> level),
        to_above((static_cast<std::size_t>(canvas.height) >> level) * stride) {}
};

/// The caller's scratch, cut up: low-pass images of odd and even levels take turns, and one row stands for the row
/// above an odd number of rows.
template <class T>
struct Scratch {
  T* odd;
  T* even;
  T* outside;

  Scratch(const HaarCanvas& canvas, T* begin)
      : odd(begin),
        even(odd + product(canvas.extent_x(1), canvas.extent_y(1))),
        outside(even + product(canvas.extent_x(2), canvas.extent_y(2))) {}

  [[nodiscard]] T* low(int level) const { return level % 2 == 1 ? odd : even; }
};

template <class T>
void split_rows(const T* __restrict lower, const T* __restrict upper, std::size_t width, T* __restrict low,
                T* __restrict column, T* __restrict row, T* __restrict diagonal) {
  const T half = T(0.5);
  const std::size_t pairs = width / 2;
  for (std::size_t i = 0; i < pairs; ++i) {
    const T lower_sum = lower[2 * i] + lower[2 * i + 1];
    const T lower_difference = lower[2 * i] - lower[2 * i + 1];
    const T upper_sum = upper[2 * i] + upper[2 * i + 1];
    const T upper_difference = upper[2 * i] - upper[2 * i + 1];
    low[i] = half * (lower_sum + upper_sum);
    column[i] = half * (lower_difference + upper_difference);
    row[i] = half * (lower_sum - upper_sum);
    diagonal[i] = half * (lower_difference - upper_difference);
  }
  if (width % 2 == 1) {  // the cell to the right is unknown: 0
    low[pairs] = column[pairs] = half * (lower[width - 1] + upper[width - 1]);
    row[pairs] = diagonal[pairs] = half * (lower[width - 1] - upper[width - 1]);
  }
}

template <class T>
void join_rows(const T* __restrict low, const T* __restrict column, const T* __restrict row,
               const T* __restrict diagonal, std::size_t width, T* __restrict lower, T* __restrict upper) {
  const T half = T(0.5);
  const std::size_t pairs = width / 2;
  for (std::size_t i = 0; i < pairs; ++i) {
    const T lower_sum = low[i] + row[i];
    const T lower_difference = column[i] + diagonal[i];
    const T upper_sum = low[i] - row[i];
    const T upper_difference = column[i] - diagonal[i];
    lower[2 * i] = half * (lower_sum + lower_difference);
    lower[2 * i + 1] = half * (lower_sum - lower_difference);
    upper[2 * i] = half * (upper_sum + upper_difference);
    upper[2 * i + 1] = half * (upper_sum - upper_difference);
  }
  if (width % 2 == 1) {
    lower[width - 1] = half * ((low[pairs] + row[pairs]) + (column[pairs] + diagonal[pairs]));
    upper[width - 1] = half * ((low[pairs] - row[pairs]) + (column[pairs] - diagonal[pairs]));
  }
}

template <class T>
void split_image(const Step& step, const T* fine, T* low, T* canvas, const T* zeros) {
  for (std::size_t y = 0; y < step.height; y += 2) {
    const T* lower = fine + y * step.width;
    const T* upper = y + 1 < step.height ? lower + step.width : zeros;
    T* at = canvas + y / 2 * step.stride;
    split_rows(lower, upper, step.width, low + y / 2 * ((step.width + 1) / 2), at + step.to_right, at + step.to_above,
               at + step.to_above + step.to_right);
  }
}

template <class T>
void join_image(const Step& step, const T* low, const T* canvas, T* fine, T* discarded) {
  for (std::size_t y = 0; y < step.height; y += 2) {
    T* lower = fine + y * step.width;
    T* upper = y + 1 < step.height ? lower + step.width : discarded;
    const T* at = canvas + y / 2 * step.stride;
    join_rows(low + y / 2 * ((step.width + 1) / 2), at + step.to_right, at + step.to_above,
              at + step.to_above + step.to_right, step.width, lower, upper);
  }
}

template <class T>
void split_line(const T* __restrict fine, std::size_t length, T* __restrict low, T* __restrict detail,
                std::size_t stride) {
  const T scale = T(1) / std::numbers::sqrt2_v<T>;
  for (std::size_t i = 0; i < length; i += 2) {
    const T a = fine[i];
    const T b = i + 1 < length ? fine[i + 1] : T(0);
    low[i / 2] = scale * (a + b);
    detail[i / 2 * stride] = scale * (a - b);
  }
}

template <class T>
void join_line(const T* __restrict low, const T* __restrict detail, std::size_t stride, T* __restrict fine,
               std::size_t length) {
  const T scale = T(1) / std::numbers::sqrt2_v<T>;
  for (std::size_t i = 0; i < length; i += 2) {
    fine[i] = scale * (low[i / 2] + detail[i / 2 * stride]);
    if (i + 1 < length) {
      fine[i + 1] = scale * (low[i / 2] - detail[i / 2 * stride]);
    }
  }
}

template <class T>
void forward(const HaarCanvas& canvas, std::span<const T> values, std::span<T> coefficients, std::span<T> scratch) {
  EXPECTS(values.size() == canvas.cells() && coefficients.size() == canvas.size());
  EXPECTS(scratch.size() >= canvas.scratch_size());
  if (canvas.cells() != canvas.size()) {
    std::fill(coefficients.begin(), coefficients.end(), T(0));
  }
  const Scratch<T> parts(canvas, scratch.data());
  std::fill_n(parts.outside, canvas.map_width, T(0));
  const T* image = values.data();
  for (int level = 1; level <= canvas.levels; ++level) {
    const Step step(canvas, level);
    T* low = parts.low(level);
    if (level <= canvas.square_levels()) {
      split_image(step, image, low, coefficients.data(), parts.outside);
    } else if (canvas.width > canvas.height) {
      split_line(image, step.width, low, coefficients.data() + step.to_right, 1);
    } else {
      split_line(image, step.height, low, coefficients.data() + step.to_above, step.stride);
    }
    image = low;
  }
  coefficients[0] = image[0];
}

template <class T>
void inverse(const HaarCanvas& canvas, std::span<const T> coefficients, std::span<T> values, std::span<T> scratch) {
  EXPECTS(values.size() == canvas.cells() && coefficients.size() == canvas.size());
  EXPECTS(scratch.size() >= canvas.scratch_size());
  const Scratch<T> parts(canvas, scratch.data());
  const T* low = coefficients.data();
  for (int level = canvas.levels; level >= 1; --level) {
    const Step step(canvas, level);
    T* image = level == 1 ? values.data() : parts.low(level - 1);
    if (level <= canvas.square_levels()) {
      join_image(step, low, coefficients.data(), image, parts.outside);
    } else if (canvas.width > canvas.height) {
      join_line(low, coefficients.data() + step.to_right, 1, image, step.width);
    } else {
      join_line(low, coefficients.data() + step.to_above, step.stride, image, step.height);
    }
    low = image;
  }
  if (canvas.levels == 0) {
    values[0] = coefficients[0];
  }
}

}  // namespace

HaarCanvas HaarCanvas::covering(int map_width, int map_height) {
  EXPECTS(map_width >= 1 && map_width <= kMaxSide && map_height >= 1 && map_height <= kMaxSide);
  const auto grown = [](int side) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(side))); };
  const int width = grown(map_width);
  const int height = grown(map_height);
  return {map_width, map_height, width, height, log2_of(std::max(width, height))};
}

std::size_t HaarCanvas::cells() const { return product(map_width, map_height); }

std::size_t HaarCanvas::size() const { return product(width, height); }

int HaarCanvas::square_levels() const { return log2_of(std::min(width, height)); }

std::size_t HaarCanvas::support() const {
  std::size_t count = 1;
  for (int level = 1; level <= levels; ++level) {
    count += (level <= square_levels() ? 3U : 1U) * product(extent_x(level), extent_y(level));
  }
  return count;
}

std::size_t HaarCanvas::scratch_size() const {
  return product(extent_x(1), extent_y(1)) + product(extent_x(2), extent_y(2)) + static_cast<std::size_t>(map_width);
}

void haar_forward(const HaarCanvas& canvas, std::span<const float> values, std::span<float> coefficients,
                  std::span<float> scratch) {
  forward(canvas, values, coefficients, scratch);
}

void haar_forward(const HaarCanvas& canvas, std::span<const double> values, std::span<double> coefficients,
                  std::span<double> scratch) {
  forward(canvas, values, coefficients, scratch);
}

void haar_inverse(const HaarCanvas& canvas, std::span<const float> coefficients, std::span<float> values,
                  std::span<float> scratch) {
  inverse(canvas, coefficients, values, scratch);
}

void haar_inverse(const HaarCanvas& canvas, std::span<const double> coefficients, std::span<double> values,
                  std::span<double> scratch) {
  inverse(canvas, coefficients, values, scratch);
}

}  // namespace cogslam
