#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "slam/codec/tile_cells.hpp"

namespace cogslam {

// The second resolution of a tile: 8 x 8 coarse cells of 4 x 4 cells each. A code of its own for them: a nibble per
// coarse cell, level + 5, the low half of a byte first.

inline constexpr int kCoarseSide = 4;  ///< cells
inline constexpr std::size_t kCoarseCodeBytes = kTileCells / (kCoarseSide * kCoarseSide) / 2;

/// True where no cell is above `highest`: a tile that says nothing of obstacles.
bool nothing_above(const TileCells& tile, std::int8_t highest);

/// Gives all cells of a coarse cell their mean level, halves away from 0.
void coarsen(TileCells& tile);

/// The code of a coarsened tile with levels -5 to 8.
std::array<std::uint8_t, kCoarseCodeBytes> encode_coarse(const TileCells& tile);

/// False, and `tile` left open, where the code is none.
bool decode_coarse(std::span<const std::uint8_t> code, TileCells& tile);

}  // namespace cogslam
