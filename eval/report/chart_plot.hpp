#pragma once

#include <cstddef>

#include "eval/report/chart.hpp"
#include "eval/report/chart_pen.hpp"

namespace cogslam {

inline constexpr int kChartWidth = 760;   ///< [pixels]
inline constexpr int kChartHeight = 470;  ///< without the legend [pixels]
inline constexpr int kLegendRow = 24;     ///< [pixels]

/// Rows that the legend of a chart takes.
std::size_t legend_rows(const Chart& chart);

/// Draws one chart with its upper left corner at `corner` [pixels].
void draw_chart(ChartPen& pen, const Chart& chart, const Eigen::Vector2d& corner);

}  // namespace cogslam
