#include "eval/report/scale_bar.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/check.hpp"
#include "eval/report/palette.hpp"

namespace cogslam {

void draw_scale_bar(Canvas& canvas, int x, int y, double pixels_per_metre) {
  EXPECTS(pixels_per_metre > 0.0);
  double metres = 1.0;
  while (metres * pixels_per_metre < 24.0) metres *= 10.0;
  const int length = static_cast<int>(std::lround(metres * pixels_per_metre));
  canvas.fill_rectangle(x, y + 6, length, 4, kBlack);
  for (const int end : {x, x + length - 2}) canvas.fill_rectangle(end, y, 2, 16, kBlack);
  canvas.draw_text(x + length + 10, y, fmt::format("{} m", metres), 2, kBlack);
}

}  // namespace cogslam
