#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cogslam {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Colour&) const = default;
};

/// A picture to draw on. Points are in pixels: x to the right, y downwards, pixel (i, j) covers [i, i+1) x [j, j+1).
/// What falls outside is not drawn.
class Canvas {
 public:
  Canvas(int width, int height, Colour background);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Colour pixel(int x, int y) const;

  /// Mixes `colour` into a pixel; `share` in [0, 1] of it covers the pixel.
  void blend(int x, int y, Colour colour, double share);
  void fill_rectangle(int x, int y, int width, int height, Colour colour);
  /// Pixels whose centre is inside (even-odd rule).
  void fill_polygon(std::span<const Eigen::Vector2d> corners, Colour colour);
  void draw_disc(const Eigen::Vector2d& centre, double radius, Colour colour);
  /// Straight strokes of `width` pixels with round ends and joints, anti-aliased. Where strokes of the same line
  /// overlap, nothing gets darker.
  void draw_line(std::span<const Eigen::Vector2d> points, double width, Colour colour);
  /// Printable ASCII with its upper left corner at (x, y), each dot of the font `scale` pixels wide. Other characters
  /// are drawn as '?'.
  void draw_text(int x, int y, std::string_view text, int scale, Colour colour);
  static int text_width(std::string_view text, int scale);
  static int text_height(int scale);

  /// Red, green and blue of each pixel, row-major, top row first: what png_bytes takes.
  [[nodiscard]] const std::vector<std::uint8_t>& rgb() const { return rgb_; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const;

  int width_;
  int height_;
  std::vector<std::uint8_t> rgb_;
};

}  // namespace cogslam
