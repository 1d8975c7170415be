#pragma once

#include <cstddef>
#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// Recovery of a map from some of its cells (compressive mobile sensing, eqs. 11, 12): min TV(m) subject to m = y on
/// the cells that A selects.
///
/// TV is isotropic, with the differences to the cell one row and one column before, 0 in the first row and column
/// (eq. 11). Cutting a map to [min y, max y] never raises its TV, so the search keeps to that box; this makes the dual
/// bound, and so the gap, rigorous. Solved by the primal-dual method of Chambolle and Pock (2011). Asks for a selection
/// of distinct cells.
struct TotalVariation {
  std::size_t width = 0;      ///< cells per row of the row-major map
  std::size_t height = 0;     ///< rows; width * height == a.cols()
  double stop_at_gap = 1e-3;  ///< relative duality gap that ends the run, > 0
  int max_iterations = 100000;
};

/// `y`: a.rows() >= 1 values. The result's x is the map; converged: the gap was reached.
[[nodiscard]] Recovered recover(const TotalVariation& tv, const MapView& a, std::span<const double> y);

/// TV of a row-major map, eq. 11.
[[nodiscard]] double total_variation(std::span<const double> map, std::size_t width);

}  // namespace cogslam
