#pragma once

#include <cstdint>
#include <string>

#include "core/grid.hpp"
#include "slam/mobile_sensing/laser_map.hpp"

namespace cogslam {

/// The rectangle ahead of the robot that one partial map covers: x from the base forward, y to both sides.
struct PartialMapConfig {
  int across_cells = 64;  ///< along y, half to either side
  int ahead_cells = 32;   ///< along x
  double cell_size_m = 0.25;
  LaserModel model{.sigma_m = 0.2, .range_max_m = 8.0};  ///< blurred by nearly a cell, walls compare better

  /// Cells of a partial map, the paper's N.
  [[nodiscard]] int cells() const { return across_cells * ahead_cells; }
  /// In the frame of the base. Asks for a config that passes its check().
  [[nodiscard]] GridFrame frame() const;
  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

/// What the robot knows of the rectangle ahead of it, in the frame of its base at that moment.
struct PartialMap {
  Grid<double> occupancy;  ///< p of each cell; 0.5 where nothing is known
  Grid<double> weight;     ///< how far a cell counts in comparisons, in [0, 1]
};

/// Everything that one sweep says, cell by cell (eqs. 6 to 8).
PartialMap partial_map(const PartialMapConfig& config, const Scan& scan);

/// A partial map out of these values. A cell counts (weight 1) where it is more than `kKnownMargin` off 0.5, or where
/// one of its eight neighbours is occupied by more than that: before a wall lie cells in which free and occupied halves
/// cancel out. What borders on free cells alone is the edge of the view, which moves with the robot.
PartialMap with_weights(Grid<double> occupancy);
inline constexpr double kKnownMargin = 0.1;

/// The map that comes back from `samples` of its cells, drawn at random (eq. 3), by total variation (eqs. 11, 12).
/// Throws InputError unless 1 <= samples <= cells. With every cell sampled the map comes back as it is.
PartialMap recover_from_samples(const PartialMap& map, int samples, std::uint32_t seed, std::uint32_t index);

}  // namespace cogslam
