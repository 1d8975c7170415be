#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/grid.hpp"

namespace cogslam {

/// A quadtree with equal-value pruning, without pointers: the smallest square of power-of-two side over the map, in
/// depth-first order. A square of more than one cell writes one bit, 1 where its cells differ and it is divided; a
/// square of equal cells (or of one) writes its value, 4 bytes. Squares without a cell of the map write nothing. First
/// the bits, filled up to whole bytes, then the values.
std::string quadtree_encoded(const Grid<float>& map);
std::vector<float> quadtree_decoded(std::string_view bytes, const GridFrame& frame);

}  // namespace cogslam
