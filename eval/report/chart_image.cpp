#include "eval/report/chart_image.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "eval/report/palette.hpp"

namespace cogslam {
namespace {

Colour mixed(Colour from, Colour to, double share) {
  const auto mix = [share](int a, int b) { return static_cast<std::uint8_t>(std::lround(a + share * (b - a))); };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

/// Values to colours. Diverging ones by the square root: coefficients span decades, and small ones must be seen.
class Shades {
 public:
  explicit Shades(const ChartImage& image) : diverging_(image.diverging) {
    const auto [least, most] = std::minmax_element(image.values.values().begin(), image.values.values().end());
    min_ = *least;
    span_ = diverging_ ? std::max(std::abs(*least), std::abs(*most)) : *most - *least;
    if (!(span_ > 0.0)) span_ = 1.0;
  }
  [[nodiscard]] Colour of(float value) const {
    if (!diverging_) return mixed(kWhite, kBlack, (static_cast<double>(value) - min_) / span_);
    return mixed(kWhite, value < 0.0F ? kBlue : kVermilion, std::sqrt(std::abs(static_cast<double>(value)) / span_));
  }

 private:
  bool diverging_;
  double min_ = 0.0;
  double span_ = 1.0;
};

}  // namespace

void draw_image(ChartPen& pen, const ChartImage& image, const Eigen::Vector2d& corner, double width, double height) {
  const GridFrame& frame = image.values.frame();
  EXPECTS(frame.size() > 0);
  const double fit = std::min(width / frame.width, height / frame.height),
               cell = fit > 1.0 ? std::floor(2.0 * fit) / 2.0 : fit;
  const double left = std::floor(corner.x() + (width - cell * frame.width) / 2.0);
  const Shades shades(image);
  pen.rectangle(left - 1, corner.y() - 1, cell * frame.width + 2, cell * frame.height + 2, kGrey);
  pen.rectangle(left, corner.y(), cell * frame.width, cell * frame.height, shades.of(0.0F));
  for (int y = 0; y < frame.height; ++y) {
    const int row = image.y_down ? y : frame.height - 1 - y;
    for (int x = 0, next = 0; x < frame.width; x = next) {
      const float value = image.values[{x, y}];
      while (next < frame.width && image.values[{next, y}] == value) ++next;
      if (value == 0.0F) continue;  // already there, and most coefficients are
      pen.rectangle(left + x * cell, corner.y() + row * cell, (next - x) * cell, cell, shades.of(value));
    }
  }
}

}  // namespace cogslam
