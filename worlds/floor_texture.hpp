#pragma once

#include <cstdint>
#include <vector>

#include "worlds/world.hpp"

namespace cogslam {

/// A square piece of floor as grey values. It repeats without a seam in both directions, so that the floor has no end.
/// Texel (column, row) covers x in [column, column + 1) and y in [row, row + 1) times kTexel, in the map frame.
struct FloorTexture {
  static constexpr int kSize = 2048;                 ///< texels per side
  static constexpr double kTexel = 0.001;            ///< side of a texel [m]
  static constexpr double kPeriod = kSize * kTexel;  ///< side of the square [m]

  std::vector<std::uint8_t> grey;  ///< row-major, kSize x kSize

  [[nodiscard]] std::uint8_t at(int column, int row) const {
    return grey[static_cast<std::size_t>(row) * kSize + static_cast<std::size_t>(column)];
  }
};

/// Paints a floor from its kind, contrast and seed alone: equal floors give equal textures, whoever asks and when.
/// The standard deviation of grey at contrast 1 is about 25 for carpet, 11 for wood, 8 for concrete, 12 for tile (6
/// within one tile) and 0 for plain; contrast scales the distance from mid-grey (128).
FloorTexture paint_floor(const Floor& floor);

}  // namespace cogslam
