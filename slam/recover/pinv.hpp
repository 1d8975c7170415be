#pragma once

#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// l2 recovery by the Moore-Penrose pseudo-inverse (sec. 4.1, eq. 29, 32): of all x that come closest to y, the one of
/// least norm. Works for any map, by its explicit matrix.
struct PseudoInverse {
  enum class Decomposition {
    kOrthogonal,  ///< complete orthogonal decomposition: the same answer, many times faster
    kSvd,         ///< singular values, as Matlab's pinv and therefore as the paper
  };
  Decomposition decomposition = Decomposition::kOrthogonal;
};

/// `y`: a.rows() values.
[[nodiscard]] Recovered recover(const PseudoInverse& pinv, const MapView& a, std::span<const double> y);

}  // namespace cogslam
