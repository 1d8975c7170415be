#include "eval/report/chart.hpp"

#include <algorithm>

#include "core/check.hpp"
#include "eval/report/chart_pen.hpp"
#include "eval/report/chart_plot.hpp"

namespace cogslam {
namespace {

constexpr int kMargin = 20;
constexpr int kHeading = 40;

int rows_of(const ChartSheet& sheet) {
  return (static_cast<int>(sheet.charts.size()) + sheet.columns - 1) / sheet.columns;
}

int note_height(const ChartSheet& sheet) { return sheet.note.empty() ? 0 : kHeading; }

int chart_height(const ChartSheet& sheet) {
  std::size_t rows = 0;
  for (const Chart& chart : sheet.charts) rows = std::max(rows, legend_rows(chart));
  return kChartHeight + static_cast<int>(rows) * kLegendRow;
}

std::string drawn(const ChartSheet& sheet, ChartPen& pen) {
  const int width = 2 * kMargin + sheet.columns * kChartWidth;
  pen.text(width / 2.0, kMargin / 2.0, sheet.heading, TextAnchor::kMiddle);
  const int height = chart_height(sheet);
  for (std::size_t i = 0; i < sheet.charts.size(); ++i) {
    const int column = static_cast<int>(i) % sheet.columns, row = static_cast<int>(i) / sheet.columns;
    draw_chart(pen, sheet.charts[i], {kMargin + column * kChartWidth, kHeading + row * height});
  }
  pen.text(kMargin, kHeading + rows_of(sheet) * height + kMargin / 2.0, sheet.note, TextAnchor::kLeft);
  return pen.bytes();
}

template <class Pen>
std::string drawn_with(const ChartSheet& sheet) {
  EXPECTS(sheet.columns >= 1 && !sheet.charts.empty());
  Pen pen(2 * kMargin + sheet.columns * kChartWidth,
          kHeading + rows_of(sheet) * chart_height(sheet) + note_height(sheet));
  return drawn(sheet, pen);
}

}  // namespace

std::string chart_svg(const ChartSheet& sheet) { return drawn_with<SvgPen>(sheet); }

std::string chart_png(const ChartSheet& sheet) { return drawn_with<PngPen>(sheet); }

}  // namespace cogslam
