#pragma once

#include <string>

#include "worlds/world.hpp"

namespace cogslam {

/// A world as an SVG drawing, y up, at the scale 1 : `scale`: printed at its own size, a metre is 1000 / scale mm.
/// One unit of the drawing's coordinates is a metre of the map; half a metre of margin all round holds a scale bar.
/// Obstacles are filled (what lies in an odd number of them), slip patches hatched, an arrow marks the start.
std::string world_svg(const World& world, const std::string& title, double scale = 50.0);

}  // namespace cogslam
