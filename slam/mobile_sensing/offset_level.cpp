#include "slam/mobile_sensing/offset_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cogslam {
namespace {

constexpr double kLeastSupport = 1e-6;  // of weight under the blur

cv::Mat_<double> image_of(const Grid<double>& grid) {
  cv::Mat_<double> image(grid.frame().height, grid.frame().width);
  std::copy(grid.values().begin(), grid.values().end(), image.begin());
  return image;
}

cv::Mat_<double> blurred(const cv::Mat_<double>& image, double sigma) {
  cv::Mat_<double> out;
  const int radius = static_cast<int>(std::ceil(4.0 * sigma));
  cv::GaussianBlur(image, out, {2 * radius + 1, 2 * radius + 1}, sigma, sigma, cv::BORDER_CONSTANT);
  return out;
}

cv::Mat_<double> product(const cv::Mat_<double>& a, const cv::Mat_<double>& b) {
  cv::Mat_<double> out;
  cv::multiply(a, b, out);
  return out;
}

std::vector<double> values_of(const cv::Mat_<double>& image) { return {image.begin(), image.end()}; }

/// Weights of the four cells around a point, a share `t` in [0, 1) behind the second (Keys, a = -1/2).
std::array<double, 4> cubic_weights(double t) {
  return {((-0.5 * t + 1.0) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1.0, ((-1.5 * t + 2.0) * t + 0.5) * t,
          (0.5 * t - 0.5) * t * t};
}

}  // namespace

OffsetLevel::OffsetLevel(const PartialMap& map, double sigma_cells)
    : width_(map.occupancy.frame().width), height_(map.occupancy.frame().height) {
  const cv::Mat_<double> weight = image_of(map.weight);
  const cv::Mat_<double> support = blurred(weight, sigma_cells);
  const cv::Mat_<double> sum = blurred(product(image_of(map.occupancy), weight), sigma_cells);
  cv::Mat_<double> value(sum.size(), kUnchanged);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (support(y, x) > kLeastSupport) value(y, x) = sum(y, x) / support(y, x);
    }
  }
  const cv::Mat_<double> difference = (cv::Mat_<double>(1, 3) << -0.5, 0.0, 0.5);
  cv::Mat_<double> gradient_x, gradient_y;
  cv::filter2D(value, gradient_x, -1, difference, {-1, -1}, 0.0, cv::BORDER_REPLICATE);
  cv::filter2D(value, gradient_y, -1, difference.t(), {-1, -1}, 0.0, cv::BORDER_REPLICATE);
  value_ = values_of(value);
  weight_ = values_of(product(weight, support));
  gradient_x_ = values_of(gradient_x);
  gradient_y_ = values_of(gradient_y);
}

std::size_t OffsetLevel::clamped_index(int x, int y) const {
  return static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * static_cast<std::size_t>(width_) +
         static_cast<std::size_t>(std::clamp(x, 0, width_ - 1));
}

OffsetLevel::Sample OffsetLevel::at_cell(Cell c) const {
  const std::size_t i = clamped_index(c.x, c.y);
  return {value_[i], weight_[i], {gradient_x_[i], gradient_y_[i]}};
}

OffsetLevel::Sample OffsetLevel::at(const Eigen::Vector2d& p) const {
  if (!(p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= width_ - 1 && p.y() <= height_ - 1)) return {};
  const int x = static_cast<int>(p.x()), y = static_cast<int>(p.y());
  const double share_x = p.x() - x, share_y = p.y() - y;
  const auto linear = [&](const std::vector<double>& v) {
    const double low = (1.0 - share_x) * v[clamped_index(x, y)] + share_x * v[clamped_index(x + 1, y)];
    const double high = (1.0 - share_x) * v[clamped_index(x, y + 1)] + share_x * v[clamped_index(x + 1, y + 1)];
    return (1.0 - share_y) * low + share_y * high;
  };
  Sample sample{.weight = linear(weight_)};
  if (sample.weight <= 0.0) return sample;
  sample.value = cubic_value(x, y, share_x, share_y);
  sample.gradient = {linear(gradient_x_), linear(gradient_y_)};
  return sample;
}

double OffsetLevel::cubic_value(int x, int y, double share_x, double share_y) const {
  const std::array<double, 4> along_x = cubic_weights(share_x), along_y = cubic_weights(share_y);
  double value = 0.0;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      value += along_y[static_cast<std::size_t>(j)] * along_x[static_cast<std::size_t>(i)] *
               value_[clamped_index(x + i - 1, y + j - 1)];
    }
  }
  return value;
}

}  // namespace cogslam
