#include "eval/report/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/check.hpp"
#include "eval/metrics/map_error.hpp"
#include "eval/report/canvas.hpp"
#include "eval/report/palette.hpp"
#include "eval/report/png.hpp"
#include "eval/report/scale_bar.hpp"

namespace cogslam {
namespace {

constexpr int kStrip = 44;   // height of the titles above and of the scale bar below [pixels]
constexpr int kMargin = 24;  // around and between panels [pixels]
constexpr double kShortSide = 600.0, kLongSide = 1500.0;

struct Panel {
  std::string title;
  std::function<Colour(Cell)> colour;
};

double pixels_per_cell(const GridFrame& frame) {
  const double least = std::min(frame.width, frame.height), most = std::max(frame.width, frame.height);
  const double fit = std::min(kShortSide / least, kLongSide / most);
  return fit > 1.0 ? std::ceil(fit) : most > kLongSide ? fit : 1.0;
}

Colour grey(double probability) {
  const auto level = static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - probability)));
  return {level, level, level};
}

Panel estimate_panel(const Grid<float>& log_odds, const GridFrame& frame) {
  return {fmt::format("estimate, {} m cells", frame.cell_size),
          [&log_odds, &frame](Cell c) { return grey(1.0 / (1.0 + std::exp(-log_odds_at(log_odds, frame, c)))); }};
}

Panel truth_panel(const Grid<TruthCell>& truth) {
  return {"truth", [&truth](Cell c) {
            return truth[c] == TruthCell::kFree ? kWhite : truth[c] == TruthCell::kOccupied ? kBlack : kGrey;
          }};
}

void draw_panel(Canvas& canvas, const Panel& panel, const GridFrame& frame, double scale, int left) {
  const int width = static_cast<int>(frame.width * scale), height = static_cast<int>(frame.height * scale);
  canvas.draw_text(left, kStrip / 2 - 4, panel.title, 2, kBlack);
  canvas.fill_rectangle(left - 1, kStrip - 1 + kMargin, width + 2, height + 2, kSkyBlue);
  const auto cell = [&](int pixel, int cells) { return std::min(static_cast<int>((pixel + 0.5) / scale), cells - 1); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cell c{cell(x, frame.width), frame.height - 1 - cell(y, frame.height)};
      canvas.blend(left + x, kStrip + kMargin + y, panel.colour(c), 1.0);
    }
  }
}

std::string picture(const GridFrame& frame, std::initializer_list<Panel> panels) {
  EXPECTS(frame.size() > 0);
  const double scale = pixels_per_cell(frame);
  const int width = std::max(static_cast<int>(frame.width * scale), 1);
  const int height = std::max(static_cast<int>(frame.height * scale), 1);
  const int all = static_cast<int>(panels.size()) * (width + kMargin) + kMargin;
  Canvas canvas(std::max(all, 600), height + 2 * kStrip + 2 * kMargin, kWhite);
  int left = kMargin;
  for (const Panel& panel : panels) {
    draw_panel(canvas, panel, frame, scale, left);
    left += width + kMargin;
  }
  draw_scale_bar(canvas, kMargin, canvas.height() - kStrip / 2 - 16, scale / frame.cell_size);
  return png_bytes(canvas.width(), canvas.height(), canvas.rgb());
}

}  // namespace

std::string map_picture(const Grid<float>& log_odds, const Grid<TruthCell>& truth) {
  const GridFrame& frame = truth.frame();
  return picture(frame, {estimate_panel(log_odds, frame), truth_panel(truth)});
}

std::string map_picture(const Grid<float>& log_odds) {
  return picture(log_odds.frame(), {estimate_panel(log_odds, log_odds.frame())});
}

}  // namespace cogslam
