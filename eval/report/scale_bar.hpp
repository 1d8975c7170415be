#pragma once

#include "eval/report/canvas.hpp"

namespace cogslam {

/// Draws a bar with its length in metres beside it, its upper left corner at (x, y): 1 m, or the next power of ten
/// that is at least 24 pixels long.
void draw_scale_bar(Canvas& canvas, int x, int y, double pixels_per_metre);

}  // namespace cogslam
