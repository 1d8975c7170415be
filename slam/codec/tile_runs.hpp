#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "slam/codec/tile_cells.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace cogslam {

/// Bit i: bytes i of two blocks of 16 are equal.
inline std::uint32_t equal_bytes_16(const std::int8_t* a, const std::int8_t* b) {
#if defined(__SSE2__)
  const __m128i x = _mm_loadu_si128(reinterpret_cast<const __m128i*>(a));
  const __m128i y = _mm_loadu_si128(reinterpret_cast<const __m128i*>(b));
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(x, y)));
#else
  std::uint32_t mask = 0;
  for (int i = 0; i < 16; ++i) mask |= static_cast<std::uint32_t>(a[i] == b[i]) << i;
  return mask;
#endif
}

/// A bit per cell of a tile, in the order of the cells.
class CellBits {
 public:
  void set_16(int first, std::uint32_t bits) {
    words_[static_cast<std::size_t>(first) / 64] |= static_cast<std::uint64_t>(bits) << (first % 64);
  }
  /// How many bits from `first` on are set without a gap.
  [[nodiscard]] int run(int first) const {
    int length = 0;
    for (int at = first; at < kTileCells;) {
      const int in_word = 64 - at % 64;
      const std::uint64_t clear = ~words_[static_cast<std::size_t>(at) / 64] >> (at % 64);
      const int ones = std::min(clear == 0 ? 64 : std::countr_zero(clear), in_word);
      length += ones;
      if (ones < in_word) break;
      at += in_word;
    }
    return length;
  }

 private:
  std::array<std::uint64_t, kTileCells / 64> words_{};
};

/// Where the cells of a tile repeat: the row above (the row before the first is unknown: 0), or the cell before.
struct TileRepeats {
  CellBits above;
  CellBits before;

  explicit TileRepeats(const TileCells& tile) {
    static constexpr std::array<std::int8_t, kTileSide> kUnknownRow{};
    const std::int8_t* cells = tile.levels.data();
    std::array<std::int8_t, 16> shifted{};
    std::memcpy(shifted.data() + 1, cells, 15);
    for (int i = 0; i < kTileCells; i += 16) {
      above.set_16(i, equal_bytes_16(cells + i, i < kTileSide ? kUnknownRow.data() : cells + i - kTileSide));
      before.set_16(i, equal_bytes_16(cells + i, i == 0 ? shifted.data() : cells + i - 1));
    }
  }
};

/// Cells that a decoder fills in order, with the unknown row in front and room for copies that overshoot.
class TileWriter {
 public:
  [[nodiscard]] int left() const { return kTileCells - at_; }
  /// One cell; there is room (left() > 0).
  void put(std::int8_t level) { cells()[at_++] = level; }
  /// Copies of the row above, of the cell before, or of `level`; `count` <= left().
  void repeat_above(int count) {
    std::int8_t* to = cells() + at_;
    for (int i = 0; i < count; i += 16) std::memcpy(to + i, to + i - kTileSide, 16);
    at_ += count;
  }
  void repeat_before(int count) {
    std::int8_t* to = cells() + at_;
    const std::int8_t level = to[-1];
    for (int i = 0; i < count; i += 16) std::memset(to + i, level, 16);
    at_ += count;
  }
  void copy_to(TileCells& tile) const { std::memcpy(tile.levels.data(), buffer_.data() + kTileSide, kTileCells); }

 private:
  std::int8_t* cells() { return buffer_.data() + kTileSide; }

  alignas(16) std::array<std::int8_t, kTileSide + kTileCells + 16> buffer_{};
  int at_ = 0;
};

}  // namespace cogslam
