#pragma once

#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// Basis pursuit, min ||x||_1 subject to A x = y (compressive mobile sensing, eq. 4), by Douglas-Rachford splitting
/// (Lions and Mercier 1979; Combettes and Pesquet 2007): the soft threshold and the projection onto A x = y take turns.
/// Asks for orthonormal rows, on which that projection rests. One product with A and one with A' per iteration.
///
/// Every x tried is feasible, and what the projection adds, A' lambda, is a dual candidate: y . lambda / max(1,
/// ||A' lambda||_inf) bounds the optimum from below. Both iterates circle around their limits; means over some of them
/// are feasible too and come several times as close, so they are tried as well.
///
/// Reaches a gap on large problems in a quarter of NESTA's time or less (bench/recover.cpp); NESTA also knows eps > 0.
struct BasisPursuit {
  double stop_at_gap = 1e-3;    ///< relative duality gap that ends the run, > 0
  double threshold = 10.0;      ///< of the soft threshold, as a multiple of the mean of |A' y|, > 0
  int max_iterations = 100000;  ///< >= 0
};

/// `y`: a.rows() values. converged: the gap was reached; else x is the best that was seen.
[[nodiscard]] Recovered recover(const BasisPursuit& pursuit, const MapView& a, std::span<const double> y);

}  // namespace cogslam
