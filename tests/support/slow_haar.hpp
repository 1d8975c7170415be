#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cogslam::slow {

/// The Haar function that belongs to the coefficient at (column, row) of the pyramid layout, as a whole image, from its
/// definition: on its block of cells +-1 / sqrt(area), with the sign changing in the middle of the block along x for
/// column differences, along y for row differences, along both for the diagonal; zero elsewhere.
/// Sides are powers of two; blocks are squares until they span the shorter side.
inline std::vector<double> haar_function(int width, int height, int column, int row) {
  const bool is_mean = column == 0 && row == 0;
  int block_x = 1;
  int block_y = 1;
  int step = 0;
  do {  // go to coarser levels until the coefficient is among the details of this one
    ++step;
    block_x = std::min(1 << step, width);
    block_y = std::min(1 << step, height);
  } while ((is_mean && (block_x < width || block_y < height)) ||
           (!is_mean && column < width / block_x && row < height / block_y));
  const bool is_column_difference = !is_mean && column >= width / block_x;
  const bool is_row_difference = !is_mean && row >= height / block_y;
  const int x0 = column % (width / block_x) * block_x;
  const int y0 = row % (height / block_y) * block_y;
  std::vector<double> image(static_cast<std::size_t>(width * height), 0.0);
  for (int y = 0; y < block_y; ++y) {
    for (int x = 0; x < block_x; ++x) {
      const bool negative = (is_column_difference && x >= block_x / 2) != (is_row_difference && y >= block_y / 2);
      image[static_cast<std::size_t>((y0 + y) * width + x0 + x)] =
          (negative ? -1.0 : 1.0) / std::sqrt(block_x * block_y);
    }
  }
  return image;
}

/// The textbook transform, in place on a canvas whose sides are powers of two: at each level all rows, then all
/// columns.
template <class T>
void haar_rows_then_columns(int width, int height, std::vector<T>& image) {
  const T scale = T(1) / std::sqrt(T(2));
  std::vector<T> line(static_cast<std::size_t>(std::max(width, height)));
  const auto split = [&](std::size_t begin, std::size_t stride, int length) {
    for (int i = 0; i < length / 2; ++i) {
      const T a = image[begin + static_cast<std::size_t>(2 * i) * stride];
      const T b = image[begin + static_cast<std::size_t>(2 * i + 1) * stride];
      line[static_cast<std::size_t>(i)] = (a + b) * scale;
      line[static_cast<std::size_t>(length / 2 + i)] = (a - b) * scale;
    }
    for (int i = 0; i < length; ++i) {
      image[begin + static_cast<std::size_t>(i) * stride] = line[static_cast<std::size_t>(i)];
    }
  };
  for (int w = width, h = height; w > 1 || h > 1; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
    for (int y = 0; y < h && w > 1; ++y) {
      split(static_cast<std::size_t>(y * width), 1, w);
    }
    for (int x = 0; x < w && h > 1; ++x) {
      split(static_cast<std::size_t>(x), static_cast<std::size_t>(width), h);
    }
  }
}

/// Zero padding of a row-major map to a larger row-major canvas.
template <class T>
std::vector<T> padded(const std::vector<T>& map, int map_width, int map_height, int width, int height) {
  std::vector<T> image(static_cast<std::size_t>(width * height), T(0));
  for (int y = 0; y < map_height; ++y) {
    std::copy_n(map.begin() + y * map_width, map_width, image.begin() + y * width);
  }
  return image;
}

}  // namespace cogslam::slow
