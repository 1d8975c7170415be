#pragma once

#include <string>

#include "eval/page/sweep_page.hpp"

namespace cogslam {

/// The means and intervals behind the curves, as JSON: `figures` (key, name, unit, better) and `points`, one per
/// variant, world and cell size, with what tells it from others and `values` {key: [mean, half width, n]}.
std::string sweep_curves_json(const SweepPageData& data);

/// Curves of the first world at its finest cell size over the percentage kept, or over bytes where none is kept, as
/// SVG; empty where there is nothing to draw.
std::string sweep_curves_svg(const SweepPageData& data);

}  // namespace cogslam
