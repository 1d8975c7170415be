#pragma once

#include <cstddef>
#include <cstdint>

#include "slam/mobile_sensing/cell_samples.hpp"

namespace cogslam {

/// Choosing cells in rounds, each where the map is uncertain after the one before. Not in the paper, whose cells are
/// all drawn before any is sensed; a mobile robot need not fix them in advance.
///
/// Two kinds of cells are uncertain. Those beside an edge of the map of least total variation: they follow walls that
/// have been met. And those between samples that disagree: halving their distance finds borders between large areas.
struct UncertainCells {
  double random_share = 0.25;  ///< of all cells are drawn at random, before the first round; in (0, 1]
  double edge_share = 0.5;     ///< of the others are cells of the first kind; in [0, 1]
  int rounds = 16;             ///< >= 1
  double stop_at_gap = 1e-2;   ///< of the recoveries between rounds, > 0
};

/// Senses `count` <= width * height cells: the random ones are those of sense_random_cells with this seed. In each
/// round those come first that differ most from one of their four neighbours in the map of least total variation; and,
/// in the map that gives each cell the value of its nearest sample, those that differ most, the farther the sooner.
/// Of equal ones, random ones.
[[nodiscard]] CellSamples sense_uncertain_cells(const UncertainCells& plan, int width, int height, std::size_t count,
                                                std::uint32_t seed, const CellSensor& sensor);

}  // namespace cogslam
