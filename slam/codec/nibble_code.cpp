#include "slam/codec/nibble_code.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "slam/codec/tile_runs.hpp"

namespace cogslam {
namespace {

constexpr std::uint32_t kAbove = 14;
constexpr std::uint32_t kBefore = 15;
constexpr int kTwoNibbles = 15, kFourNibbles = 63;  // the first lengths that take so many

/// Writes nibbles, up to 14 at a time; needs 8 spare bytes behind the code.
class NibbleWriter {
 public:
  explicit NibbleWriter(std::uint8_t* to) : start_(to), to_(to) {}
  void put(std::uint64_t nibbles, int count) {
    pending_ |= nibbles << bits_;
    bits_ += 4 * count;
    std::memcpy(to_, &pending_, 8);
    to_ += bits_ / 8;
    pending_ >>= bits_ / 8 * 8;
    bits_ %= 8;
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(to_ - start_) + (bits_ > 0 ? 1 : 0); }

 private:
  std::uint8_t* start_;
  std::uint8_t* to_;
  std::uint64_t pending_ = 0;
  int bits_ = 0;  ///< below 8
};

void put_run(NibbleWriter& out, std::uint32_t kind, int length) {
  const auto n = static_cast<std::uint32_t>(length);
  if (length < kTwoNibbles) {
    out.put(kind | (n - kShortestRun) << 4, 2);
  } else if (length < kFourNibbles) {
    const std::uint32_t rest = n - kTwoNibbles;
    out.put(kind | (12 + rest / 16) << 4 | (rest % 16) << 8, 3);
  } else {
    out.put(kind | 15U << 4 | (n >> 8) << 8 | ((n >> 4) & 15) << 12 | (n & 15) << 16, 5);
  }
}

/// The cells of a tile as nibbles, to be copied in pieces.
class PackedTile {
 public:
  explicit PackedTile(const TileCells& tile) {
    for (std::size_t w = 0; w < kWords; ++w) words_[w] = pack_16(tile.levels.data() + 16 * w, kNibbleLowest);
  }
  /// Cells [first, first + count), count in 1..14.
  [[nodiscard]] std::uint64_t piece(int first, int count) const {
    const auto w = static_cast<std::size_t>(first) / 16;
    const int shift = first % 16 * 4;
    const std::uint64_t two = shift == 0 ? words_[w] : words_[w] >> shift | words_[w + 1] << (64 - shift);
    return two & ((std::uint64_t{1} << (4 * count)) - 1);
  }

 private:
  static constexpr std::size_t kWords = kTileCells / 16;
  std::array<std::uint64_t, kWords + 1> words_{};
};

/// Reads nibbles from a copy of the code that has room behind it.
class NibbleReader {
 public:
  explicit NibbleReader(std::span<const std::uint8_t> code) : end_(2 * static_cast<int>(code.size())) {
    std::copy(code.begin(), code.end(), code_.begin());
    std::memset(code_.data() + code.size(), 0xFF, kSpare);
  }
  /// The next 15 nibbles or more, next one lowest; what stands behind the end is not of the code.
  [[nodiscard]] std::uint64_t peek() const {
    std::uint64_t word;
    std::memcpy(&word, code_.data() + at_ / 2, 8);
    return word >> (at_ % 2 * 4);
  }
  /// False where the code has not so many.
  bool skip(int count) {
    at_ += count;
    return at_ <= end_;
  }
  [[nodiscard]] bool at_end() const { return at_ == end_ || (at_ + 1 == end_ && (peek() & 15) == 0); }

 private:
  static constexpr std::size_t kSpare = 16;
  std::array<std::uint8_t, kNibbleCodeMax + kSpare> code_;
  int at_ = 0, end_;
};

struct RunLength {
  int cells;
  int nibbles;  ///< of its code
};

RunLength run_length(std::uint64_t word) {
  const int first = static_cast<int>(word & 15), second = static_cast<int>(word >> 4 & 15);
  if (first < 12) return {kShortestRun + first, 1};
  if (first < 15) return {kTwoNibbles + 16 * (first - 12) + second, 2};
  return {second << 8 | static_cast<int>(word >> 8 & 15) << 4 | static_cast<int>(word >> 12 & 15), 4};
}

/// How many of the 15 lowest nibbles, from the lowest on, are cells: below 14, which has its three highest bits set.
int leading_cells(std::uint64_t word) {
  const std::uint64_t runs = word & word << 1 & word << 2 & 0x0888888888888888ULL;
  return runs == 0 ? 15 : std::countr_zero(runs) / 4;
}

}  // namespace

bool fits_nibbles(const TileCells& tile) {
  bool outside = false;
  for (int i = 0; i < kTileCells; i += 16) {
    outside |= outside_16(tile.levels.data() + i, kNibbleLowest, kNibbleHighest);
  }
  return !outside;
}

std::size_t encode_nibbles(const TileCells& tile, NibbleBuffer& code) {
  const TileRepeats repeats(tile);
  const PackedTile packed(tile);
  NibbleWriter out(code.data());
  for (int at = 0; at < kTileCells;) {
    const int run = repeats.starts.find(at);
    for (; at < run; at += 14) out.put(packed.piece(at, std::min(14, run - at)), std::min(14, run - at));
    at = run;
    if (at == kTileCells) break;
    const int above = repeats.above.run(at), before = repeats.before.run(at);
    put_run(out, above >= before ? kAbove : kBefore, std::max(above, before));
    at += std::max(above, before);
  }
  return out.size();
}

bool decode_nibbles(std::span<const std::uint8_t> code, TileCells& tile) {
  if (code.size() > kNibbleCodeMax) return false;
  NibbleReader in(code);
  TileWriter out;
  while (out.left() > 0) {
    const std::uint64_t word = in.peek();
    const int cells = std::min(leading_cells(word), out.left());
    out.put_packed(word, kNibbleLowest, cells);
    if (!in.skip(cells)) return false;
    if (cells == 15 || out.left() == 0) continue;
    const std::uint64_t run = in.peek();
    const RunLength length = run_length(run >> 4);
    if (!in.skip(1 + length.nibbles) || length.cells < kShortestRun || length.cells > out.left()) return false;
    if ((run & 15) == kAbove) {
      out.repeat_above(length.cells);
    } else {
      out.repeat_before(length.cells);
    }
  }
  out.copy_to(tile);
  return in.at_end();
}

}  // namespace cogslam
