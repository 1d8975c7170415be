#pragma once

#include "eval/report/chart.hpp"
#include "eval/report/chart_pen.hpp"

namespace cogslam {

/// Draws the grid as large as fits into the field (square cells, a whole number of pixels each where there is room),
/// centred, with a thin frame.
void draw_image(ChartPen& pen, const ChartImage& image, const Eigen::Vector2d& corner, double width, double height);

}  // namespace cogslam
