#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "eval/report/chart_pen.hpp"
#include "eval/report/palette.hpp"
#include "eval/report/png.hpp"

namespace cogslam {
namespace {

constexpr int kTextScale = 2;
constexpr double kBandShare = 0.25;

int nearest(double pixels) { return static_cast<int>(std::lround(pixels)); }

}  // namespace

PngPen::PngPen(int width, int height) : canvas_(width, height, kWhite) {}

void PngPen::line(std::span<const Eigen::Vector2d> points, double width, Colour colour) {
  canvas_.draw_line(points, width, colour);
}

void PngPen::polygon(std::span<const Eigen::Vector2d> corners, Colour colour) { canvas_.fill_polygon(corners, colour); }

void PngPen::band(std::span<const Eigen::Vector2d> low, std::span<const Eigen::Vector2d> high, Colour colour) {
  EXPECTS(low.size() == high.size());
  for (std::size_t i = 0; i + 1 < low.size(); ++i) {
    const double left = low[i].x(), right = low[i + 1].x();
    for (int x = nearest(left); x < nearest(right); ++x) {
      const double w = std::clamp((x + 0.5 - left) / (right - left), 0.0, 1.0);
      const double bottom = (1.0 - w) * low[i].y() + w * low[i + 1].y();
      const double top = (1.0 - w) * high[i].y() + w * high[i + 1].y();
      for (int y = nearest(top); y < nearest(bottom); ++y) canvas_.blend(x, y, colour, kBandShare);
    }
  }
}

void PngPen::rectangle(double x, double y, double width, double height, Colour colour) {
  // From rounded edge to rounded edge, so that neighbours leave no gap.
  const int left = nearest(x), top = nearest(y);
  canvas_.fill_rectangle(left, top, std::max(nearest(x + width) - left, 1), std::max(nearest(y + height) - top, 1),
                         colour);
}

void PngPen::text(double x, double y, std::string_view text, TextAnchor anchor) {
  const int width = Canvas::text_width(text, kTextScale);
  const int shift = anchor == TextAnchor::kLeft ? 0 : anchor == TextAnchor::kMiddle ? width / 2 : width;
  canvas_.draw_text(nearest(x) - shift, nearest(y), text, kTextScale, kBlack);
}

std::string PngPen::bytes() { return png_bytes(canvas_.width(), canvas_.height(), canvas_.rgb()); }

}  // namespace cogslam
