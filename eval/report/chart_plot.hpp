#pragma once

#include <cstddef>

#include "eval/report/chart.hpp"
#include "eval/report/chart_pen.hpp"

namespace cogslam {

inline constexpr int kChartWidth = 760;   ///< [pixels]
inline constexpr int kChartHeight = 470;  ///< without the legend [pixels]
inline constexpr int kLegendRow = 24;     ///< [pixels]

/// Named series of a chart, and the rows that a legend of so many takes.
std::size_t legend_entries(const Chart& chart);
std::size_t legend_rows(std::size_t entries);

/// Draws one chart with its upper left corner at `corner` [pixels].
void draw_chart(ChartPen& pen, const Chart& chart, const Eigen::Vector2d& corner);

}  // namespace cogslam
