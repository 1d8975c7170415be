#pragma once

#include <string>

#include "eval/run_folder.hpp"

namespace cogslam {

/// The curves of a page without script, as an SVG file: errors of position and heading, effective particles and bytes
/// over time, of the first filters at the finest cell size. Nothing where no run kept a trace.
std::string curves_svg(const RunFiles& files);

}  // namespace cogslam
