#pragma once

#include "eval/report/chart_pen.hpp"

namespace cogslam {

/// Curves that a chart can tell apart, by colour (Okabe and Ito) and by the shape of their markers.
inline constexpr int kLooks = 7;

Colour look_colour(int look);
/// The marker of a look, about 9 pixels wide.
void draw_marker(ChartPen& pen, const Eigen::Vector2d& centre, int look);

}  // namespace cogslam
