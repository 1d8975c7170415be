#include "eval/report/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "eval/report/font.hpp"

namespace cogslam {
namespace {

double distance_to_stroke(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double w = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - w * along).norm();
}

/// A rectangle of pixels, ends excluded.
struct Box {
  int x_min, y_min, x_max, y_max;
};

/// The pixels, cut to the canvas, that a shape around `a` and `b` with `reach` can touch.
Box box_around(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double reach, int width, int height) {
  const auto cut = [](double v, int end) { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(end))); };
  const Eigen::Vector2d low = a.cwiseMin(b).array() - reach, high = a.cwiseMax(b).array() + reach;
  return {cut(std::floor(low.x()), width), cut(std::floor(low.y()), height), cut(std::ceil(high.x()), width),
          cut(std::ceil(high.y()), height)};
}

Eigen::Vector2d centre_of_pixel(int x, int y) { return {x + 0.5, y + 0.5}; }

}  // namespace

Canvas::Canvas(int width, int height, Colour background) : width_(width), height_(height) {
  EXPECTS(width > 0 && height > 0 && width <= 32768 && height <= 32768);
  rgb_.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  fill_rectangle(0, 0, width, height, background);
}

std::size_t Canvas::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

Colour Canvas::pixel(int x, int y) const {
  EXPECTS(x >= 0 && y >= 0 && x < width_ && y < height_);
  const std::size_t at = 3 * index(x, y);
  return {rgb_[at], rgb_[at + 1], rgb_[at + 2]};
}

void Canvas::blend(int x, int y, Colour colour, double share) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  const std::size_t at = 3 * index(x, y);
  const std::uint8_t channels[3] = {colour.red, colour.green, colour.blue};
  for (std::size_t i = 0; i < 3; ++i) {
    rgb_[at + i] = static_cast<std::uint8_t>(std::lround((1.0 - share) * rgb_[at + i] + share * channels[i]));
  }
}

void Canvas::fill_rectangle(int x, int y, int width, int height, Colour colour) {
  for (int j = std::max(y, 0); j < std::min(y + height, height_); ++j) {
    for (int i = std::max(x, 0); i < std::min(x + width, width_); ++i) blend(i, j, colour, 1.0);
  }
}

void Canvas::fill_polygon(std::span<const Eigen::Vector2d> corners, Colour colour) {
  std::vector<double> crossings;
  for (int y = 0; y < height_; ++y) {
    crossings.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if ((a.y() <= y + 0.5) == (b.y() <= y + 0.5)) continue;
      crossings.push_back(a.x() + (y + 0.5 - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double from = std::clamp(std::ceil(crossings[i] - 0.5), 0.0, static_cast<double>(width_));
      for (int x = static_cast<int>(from); x < width_ && x + 0.5 < crossings[i + 1]; ++x) blend(x, y, colour, 1.0);
    }
  }
}

void Canvas::draw_disc(const Eigen::Vector2d& centre, double radius, Colour colour) {
  const Eigen::Vector2d points[] = {centre};
  draw_line(points, 2.0 * radius, colour);
}

void Canvas::draw_line(std::span<const Eigen::Vector2d> points, double width, Colour colour) {
  // The whole line becomes one mask first, so that a joint is not painted twice.
  std::vector<float> mask(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0F);
  const double reach = width / 2.0 + 1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d &a = points[i], &b = points[std::min(i + 1, points.size() - 1)];
    const Box box = box_around(a, b, reach, width_, height_);
    for (int y = box.y_min; y < box.y_max; ++y) {
      for (int x = box.x_min; x < box.x_max; ++x) {
        const double distance = distance_to_stroke(centre_of_pixel(x, y), a, b);
        const auto cover = static_cast<float>(std::clamp(width / 2.0 + 0.5 - distance, 0.0, 1.0));
        float& m = mask[index(x, y)];
        m = std::max(m, cover);
      }
    }
  }
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (const float cover = mask[index(x, y)]; cover > 0.0F) blend(x, y, colour, static_cast<double>(cover));
    }
  }
}

void Canvas::draw_text(int x, int y, std::string_view text, int scale, Colour colour) {
  for (const char letter : text) {
    for (int column = 0; column < kGlyphWidth; ++column) {
      for (int row = 0; row < kGlyphHeight; ++row) {
        const bool dot = (glyph(letter)[static_cast<std::size_t>(column)] >> row & 1) != 0;
        if (dot) fill_rectangle(x + column * scale, y + row * scale, scale, scale, colour);
      }
    }
    x += (kGlyphWidth + 1) * scale;
  }
}

int Canvas::text_width(std::string_view text, int scale) {
  return std::max(static_cast<int>(text.size()) * (kGlyphWidth + 1) - 1, 0) * scale;
}

int Canvas::text_height(int scale) { return kGlyphHeight * scale; }

}  // namespace cogslam
