#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "slam/codec/tile_cells.hpp"

namespace cogslam {

// A fast code for tiles of the 14-level lattice (levels -5 to 8): two-dimensional run lengths, four bits at a time, the
// low half of a byte first. Cells go row by row:
//
//   0..13    one cell of level (nibble - 5)
//   14, n    n cells as in the row above (the row before the first is unknown)
//   15, n    n cells like the one before
//
// A length n >= 3 is written as a nibble below 12 (n = 3 + nibble), as two (12..14, then 0..15: n = 15 + 16 (a - 12) +
// b), or as 15 and three nibbles, highest first. A last unused half byte is 0.

inline constexpr int kNibbleLowest = -5;
inline constexpr int kNibbleHighest = 8;
inline constexpr std::size_t kNibbleCodeMax = kTileCells / 2;  ///< bytes: no code is longer than a nibble per cell

using NibbleBuffer = std::array<std::uint8_t, kNibbleCodeMax + 16>;

/// True where every level of the tile has a nibble.
bool fits_nibbles(const TileCells& tile);

/// Writes the code of a tile that fits, and returns its length in bytes.
std::size_t encode_nibbles(const TileCells& tile, NibbleBuffer& code);

/// Reads a code. False, and `tile` left open, where it is none: too short, too long or beside the rules above.
bool decode_nibbles(std::span<const std::uint8_t> code, TileCells& tile);

}  // namespace cogslam
