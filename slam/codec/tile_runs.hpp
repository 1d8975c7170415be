#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "slam/codec/sixteen_cells.hpp"

namespace cogslam {

inline constexpr int kShortestRun = 3;  ///< cells: a shorter run costs no less than its cells

/// A bit per cell of a tile, in the order of the cells.
class CellBits {
 public:
  void set_16(int first, std::uint32_t bits) { word(first) |= static_cast<std::uint64_t>(bits) << (first % 64); }

  /// How many bits from `first` on are set without a gap.
  [[nodiscard]] int run(int first) const { return next(first, ~std::uint64_t{0}) - first; }
  /// The first set bit at or behind `first`; kTileCells where there is none.
  [[nodiscard]] int find(int first) const { return next(first, 0); }

  /// Bits that begin a run of at least kShortestRun in `a` or in `b`.
  static CellBits starts(const CellBits& a, const CellBits& b) {
    CellBits result;
    for (std::size_t w = 0; w < kWords; ++w) result.words_[w] = a.run_starts(w) | b.run_starts(w);
    return result;
  }

 private:
  static constexpr std::size_t kWords = kTileCells / 64;
  std::uint64_t& word(int cell) { return words_[static_cast<std::size_t>(cell) / 64]; }
  [[nodiscard]] std::uint64_t run_starts(std::size_t w) const {
    const std::uint64_t here = words_[w], behind = w + 1 < kWords ? words_[w + 1] : 0;
    return here & (here >> 1 | behind << 63) & (here >> 2 | behind << 62);
  }
  /// The first bit that is set after flipping all by `flip`.
  [[nodiscard]] int next(int first, std::uint64_t flip) const {
    if (first >= kTileCells) return kTileCells;
    auto w = static_cast<std::size_t>(first) / 64;
    std::uint64_t bits = (words_[w] ^ flip) >> (first % 64);
    if (bits != 0) return first + std::countr_zero(bits);
    while (++w < kWords) {
      if ((words_[w] ^ flip) != 0) return static_cast<int>(64 * w) + std::countr_zero(words_[w] ^ flip);
    }
    return kTileCells;
  }

  std::array<std::uint64_t, kWords> words_{};
};

/// Where the cells of a tile repeat: the row above (the row before the first is unknown: 0), or the cell before.
struct TileRepeats {
  CellBits above;
  CellBits before;
  CellBits starts;  ///< where either is a run worth its code

  explicit TileRepeats(const TileCells& tile) {
    static constexpr std::array<std::int8_t, kTileSide> kUnknownRow{};
    const std::int8_t* cells = tile.levels.data();
    std::array<std::int8_t, 16> shifted{};
    std::memcpy(shifted.data() + 1, cells, 15);
    for (int i = 0; i < kTileCells; i += 16) {
      above.set_16(i, equal_16(cells + i, i < kTileSide ? kUnknownRow.data() : cells + i - kTileSide));
      before.set_16(i, equal_16(cells + i, i == 0 ? shifted.data() : cells + i - 1));
    }
    starts = CellBits::starts(above, before);
  }
};

/// Cells that a decoder fills in order, with the unknown row in front and room for writes that overshoot.
class TileWriter {
 public:
  TileWriter() { std::memset(buffer_.data(), 0, kTileSide); }

  [[nodiscard]] int left() const { return kTileCells - at_; }
  void put(std::int8_t level) { cells()[at_++] = level; }
  /// The first `count` <= 16 of sixteen packed cells; `count` <= left(), as with all that follow.
  void put_packed(std::uint64_t packed, int lowest, int count) {
    unpack_16(packed, lowest, cells() + at_);
    at_ += count;
  }
  /// Cells as in the row above.
  void repeat_above(int count) {
    std::int8_t* to = cells() + at_;
    for (int i = 0; i < count; i += 16) std::memcpy(to + i, to + i - kTileSide, 16);
    at_ += count;
  }
  /// Cells like the one before.
  void repeat_before(int count) {
    std::int8_t* to = cells() + at_;
    const std::int8_t level = to[-1];
    for (int i = 0; i < count; i += 16) std::memset(to + i, level, 16);
    at_ += count;
  }
  void copy_to(TileCells& tile) const { std::memcpy(tile.levels.data(), buffer_.data() + kTileSide, kTileCells); }

 private:
  std::int8_t* cells() { return buffer_.data() + kTileSide; }

  alignas(16) std::array<std::int8_t, kTileSide + kTileCells + 16> buffer_;  // what is read has been written before
  int at_ = 0;
};

}  // namespace cogslam
