#pragma once

#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// l2 recovery by the transpose, x = A' y (eq. 69): the pseudo-inverse of a map with orthonormal rows. For a selection
/// it copies m values into zeros (Alg. 8). Asks for orthonormal rows.
struct FastL2 {};

/// `y`: a.rows() values.
[[nodiscard]] Recovered recover(const FastL2& fast_l2, const MapView& a, std::span<const double> y);

}  // namespace cogslam
