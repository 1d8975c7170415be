#pragma once

#include <string>

#include "core/grid.hpp"
#include "worlds/truth_grid.hpp"

// PNG files in memory; write them with core/output_file.hpp. The map's x axis points to the right, its y axis up. A
// cell is a whole number of pixels (panels are at least 600 pixels wide and high unless the map is very long), or less
// than one where the map has more than 1500 cells along a side. Grids without cells break the contract.

namespace cogslam {

/// The estimated map (white free, black occupied, grey by probability in between) beside the true one (grey where
/// unobservable), over the truth's frame.
std::string map_picture(const Grid<float>& log_odds, const Grid<TruthCell>& truth);

/// The estimated map alone, where no truth is known.
std::string map_picture(const Grid<float>& log_odds);

}  // namespace cogslam
