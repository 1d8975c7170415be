#pragma once

#include <cstdint>
#include <vector>

#include "slam/mobile_sensing/cell_samples.hpp"

namespace cogslam {

/// For each cell of a field the sample that is nearest to it, centre to centre.
struct NearestSamples {
  std::vector<std::uint32_t> sample;  ///< index into CellSamples::cells; of equally near ones any, always the same
  std::vector<double> distance;       ///< in cells
};

/// Of at least one sample, exactly: first along columns, then along rows. Time width * cells.
[[nodiscard]] NearestSamples nearest_samples(const CellSamples& samples);

}  // namespace cogslam
