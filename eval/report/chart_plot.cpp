#include "eval/report/chart_plot.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "eval/report/chart_image.hpp"
#include "eval/report/chart_marker.hpp"
#include "eval/report/chart_scale.hpp"
#include "eval/report/palette.hpp"

namespace cogslam {
namespace {

constexpr int kLeft = 100, kRight = 24, kTop = 56, kBottom = 64;
constexpr std::size_t kShortName = 26;  // letters of names that fit two to a row

/// The field within the axes, and where values fall in it.
struct Plot {
  Eigen::Vector2d corner;
  double width = kChartWidth - kLeft - kRight;
  double height = kChartHeight - kTop - kBottom;
  ChartScale x, y;

  [[nodiscard]] double right() const { return corner.x() + width; }
  [[nodiscard]] double bottom() const { return corner.y() + height; }
  /// Nothing where it cannot be shown. Beyond the upper or lower end it is put onto it.
  [[nodiscard]] std::optional<Eigen::Vector2d> at(double vx, double vy) const {
    const auto px = x.position(vx), py = y.position(vy);
    if (!px || !py || *px < -1e-9 || *px > 1.0 + 1e-9) return std::nullopt;
    return Eigen::Vector2d(corner.x() + width * *px, bottom() - height * std::clamp(*py, 0.0, 1.0));
  }
};

using Points = std::vector<Eigen::Vector2d>;

std::vector<double> all_values(const Chart& chart, bool along_x) {
  std::vector<double> values;
  for (const Series& s : chart.series) {
    const auto add = [&](const std::vector<double>& v) { values.insert(values.end(), v.begin(), v.end()); };
    add(along_x ? s.x : s.y);
    if (!along_x && !chart.y.log) add(s.low);
    if (!along_x) add(s.high);
    if (!along_x && s.style == SeriesStyle::kStems) values.push_back(0.0);
  }
  return values;
}

/// Stretches of a series without gaps.
std::vector<Points> stretches(const Plot& plot, const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<Points> result(1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (const auto p = plot.at(x[i], y[i])) {
      result.back().push_back(*p);
    } else if (!result.back().empty()) {
      result.emplace_back();
    }
  }
  std::erase_if(result, [](const Points& points) { return points.empty(); });
  return result;
}

void draw_frame(ChartPen& pen, const Chart& chart, const Plot& plot) {
  for (const Tick& tick : plot.x.ticks()) {
    const double x = plot.corner.x() + plot.width * *plot.x.position(tick.value);
    pen.rectangle(x, plot.corner.y(), 1, plot.height, kLightGrey);
    pen.text(x, plot.bottom() + 10, tick.label, TextAnchor::kMiddle);
  }
  for (const Tick& tick : plot.y.ticks()) {
    const double y = plot.bottom() - plot.height * *plot.y.position(tick.value);
    pen.rectangle(plot.corner.x(), y, plot.width, 1, kLightGrey);
    pen.text(plot.corner.x() - 10, y - kLetterHeight / 2.0, tick.label, TextAnchor::kRight);
  }
  pen.rectangle(plot.corner.x(), plot.bottom(), plot.width, 2, kBlack);
  pen.rectangle(plot.corner.x(), plot.corner.y(), 2, plot.height, kBlack);
  pen.text(plot.corner.x() + plot.width / 2.0, plot.bottom() + 36, chart.x.label, TextAnchor::kMiddle);
}

void draw_band(ChartPen& pen, const Plot& plot, const Series& s, Colour colour) {
  if (s.low.empty()) return;
  EXPECTS(s.low.size() == s.x.size() && s.high.size() == s.x.size());
  Points low, high;
  const auto flush = [&] {
    if (low.size() > 1) pen.band(low, high, colour);
    low.clear();
    high.clear();
  };
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const auto top = plot.at(s.x[i], s.high[i]);
    // On a logarithmic axis an interval may reach below zero: it is cut at the axis.
    const auto bottom = plot.at(s.x[i], std::max(s.low[i], plot.y.min()));
    if (!top || !bottom || !std::isfinite(s.low[i])) {
      flush();
      continue;
    }
    low.push_back(*bottom);
    high.push_back(*top);
  }
  flush();
}

void draw_stems(ChartPen& pen, const Plot& plot, const Series& s, Colour colour) {
  const double zero = plot.at(plot.x.min(), 0.0)->y();
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (const auto p = plot.at(s.x[i], s.y[i])) {
      pen.rectangle(p->x() - 1.0, std::min(p->y(), zero), 3, std::abs(p->y() - zero), colour);
    }
  }
}

void draw_series(ChartPen& pen, const Plot& plot, const Series& s, int look) {
  EXPECTS(s.x.size() == s.y.size());
  const Colour colour = look_colour(look);
  if (s.style == SeriesStyle::kStems) return draw_stems(pen, plot, s, colour);
  for (const Points& points : stretches(plot, s.x, s.y)) {
    if (s.style != SeriesStyle::kPointsOnly) pen.line(points, 2.0, colour);
    if (s.style == SeriesStyle::kLineOnly) continue;
    for (const Eigen::Vector2d& p : points) draw_marker(pen, p, look);
  }
}

int look_of(const Chart& chart, std::size_t i) { return chart.series[i].look.value_or(static_cast<int>(i) % kLooks); }

std::size_t legend_columns(const Chart& chart) {
  const bool brief = std::ranges::all_of(chart.series, [](const Series& s) { return s.name.size() <= kShortName; });
  return brief ? 2 : 1;
}

void draw_legend(ChartPen& pen, const Chart& chart, const Eigen::Vector2d& corner) {
  std::size_t place = 0;
  const std::size_t columns = legend_columns(chart);
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& s = chart.series[i];
    if (s.name.empty()) continue;
    const double x = corner.x() + static_cast<double>(place % columns) * (kChartWidth - 10.0) / 2.0;
    const double y = corner.y() + static_cast<double>(place / columns) * kLegendRow;
    const Points sample{{x, y}, {x + 30.0, y}};
    if (s.style != SeriesStyle::kPointsOnly) pen.line(sample, 2.0, look_colour(look_of(chart, i)));
    if (s.style == SeriesStyle::kLine || s.style == SeriesStyle::kPointsOnly) {
      draw_marker(pen, {x + 15.0, y}, look_of(chart, i));
    }
    pen.text(x + 40.0, y - kLetterHeight / 2.0, s.name, TextAnchor::kLeft);
    ++place;
  }
}

}  // namespace

std::size_t legend_rows(const Chart& chart) {
  const auto entries = static_cast<std::size_t>(
      std::count_if(chart.series.begin(), chart.series.end(), [](const Series& s) { return !s.name.empty(); }));
  return (entries + legend_columns(chart) - 1) / legend_columns(chart);
}

void draw_chart(ChartPen& pen, const Chart& chart, const Eigen::Vector2d& corner) {
  const Eigen::Vector2d field = corner + Eigen::Vector2d(kLeft, kTop);
  pen.text(corner.x() + kLeft + (kChartWidth - kLeft - kRight) / 2.0, corner.y() + 4, chart.title, TextAnchor::kMiddle);
  if (chart.image) {
    draw_image(pen, *chart.image, field, kChartWidth - kLeft - kRight, kChartHeight - kTop - kBottom);
    pen.text(field.x() + (kChartWidth - kLeft - kRight) / 2.0, corner.y() + kChartHeight - kBottom + 12, chart.x.label,
             TextAnchor::kMiddle);
    return;
  }
  const Plot plot{.corner = field,
                  .x = ChartScale(chart.x, all_values(chart, true)),
                  .y = ChartScale(chart.y, all_values(chart, false))};
  pen.text(corner.x() + 4, corner.y() + 28, chart.y.label, TextAnchor::kLeft);
  draw_frame(pen, chart, plot);
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    draw_band(pen, plot, chart.series[i], look_colour(look_of(chart, i)));
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) draw_series(pen, plot, chart.series[i], look_of(chart, i));
  draw_legend(pen, chart, {corner.x() + 10.0, corner.y() + kChartHeight});
}

}  // namespace cogslam
