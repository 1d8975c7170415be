#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "slam/codec/tile_cells.hpp"

namespace cogslam {

// A fast code for tiles of any levels: two-dimensional run lengths as the nibble code, a byte at a time:
//
//   0..63      that many cells and one, a byte each, follow
//   64..127    n - 61 cells like the one before (3 to 66)
//   128..255   n - 125 cells as in the row above, the row before the first unknown (3 to 130)

inline constexpr std::size_t kByteCodeMax = kTileCells + kTileCells / 64;

using ByteBuffer = std::array<std::uint8_t, kByteCodeMax>;

/// Writes the code of a tile, and returns its length in bytes.
std::size_t encode_bytes(const TileCells& tile, ByteBuffer& code);

/// Reads a code. False, and `tile` left open, where it is none: too short, too long or beside the rules above.
bool decode_bytes(std::span<const std::uint8_t> code, TileCells& tile);

}  // namespace cogslam
