#include "slam/codec/nibble_code.hpp"

#include "slam/codec/tile_runs.hpp"

namespace cogslam {
namespace {

constexpr std::uint32_t kAbove = 14;
constexpr std::uint32_t kBefore = 15;
constexpr int kShortest = 3;                        // a shorter run costs no less than its cells
constexpr int kTwoNibbles = 15, kFourNibbles = 63;  // the first lengths that take so many

class NibbleWriter {
 public:
  explicit NibbleWriter(std::uint8_t* to) : start_(to), to_(to) {}
  void put(std::uint32_t nibbles, int count) {
    pending_ |= static_cast<std::uint64_t>(nibbles) << bits_;
    bits_ += 4 * count;
    while (bits_ >= 32) {
      for (int i = 0; i < 4; ++i) *to_++ = static_cast<std::uint8_t>(pending_ >> (8 * i));
      pending_ >>= 32;
      bits_ -= 32;
    }
  }
  std::size_t finish() {
    for (; bits_ > 0; bits_ -= 8, pending_ >>= 8) *to_++ = static_cast<std::uint8_t>(pending_);
    return static_cast<std::size_t>(to_ - start_);
  }

 private:
  std::uint8_t* start_;
  std::uint8_t* to_;
  std::uint64_t pending_ = 0;
  int bits_ = 0;
};

void put_run(NibbleWriter& out, std::uint32_t kind, int length) {
  const auto n = static_cast<std::uint32_t>(length);
  if (length < kTwoNibbles) {
    out.put(kind | (n - kShortest) << 4, 2);
  } else if (length < kFourNibbles) {
    const std::uint32_t rest = n - kTwoNibbles;
    out.put(kind | (12 + rest / 16) << 4 | (rest % 16) << 8, 3);
  } else {
    out.put(kind | 15U << 4 | (n >> 8) << 8 | ((n >> 4) & 15) << 12 | (n & 15) << 16, 5);
  }
}

class NibbleReader {
 public:
  explicit NibbleReader(std::span<const std::uint8_t> code) : code_(code), end_(2 * code.size()) {}
  [[nodiscard]] std::size_t left() const { return end_ - at_; }
  /// The next nibble; 0 behind the end.
  std::uint32_t take() {
    if (at_ >= end_) return overrun_ = true, 0;
    const std::uint32_t nibble = (code_[at_ / 2] >> (at_ % 2 * 4)) & 15U;
    ++at_;
    return nibble;
  }
  [[nodiscard]] bool overrun() const { return overrun_; }

 private:
  std::span<const std::uint8_t> code_;
  std::size_t at_ = 0, end_;
  bool overrun_ = false;
};

/// A run's length, 0 where there is none.
int take_length(NibbleReader& in) {
  const std::uint32_t first = in.take();
  if (first < 12) return kShortest + static_cast<int>(first);
  if (first < 15) return kTwoNibbles + static_cast<int>(16 * (first - 12) + in.take());
  const std::uint32_t high = in.take(), middle = in.take();
  return static_cast<int>(high << 8 | middle << 4 | in.take());
}

}  // namespace

bool fits_nibbles(const TileCells& tile) {
  std::uint32_t outside = 0;
  for (const std::int8_t level : tile.levels) {
    outside |=
        static_cast<std::uint32_t>(static_cast<std::uint8_t>(level - kNibbleLowest) > kNibbleHighest - kNibbleLowest);
  }
  return outside == 0;
}

std::size_t encode_nibbles(const TileCells& tile, NibbleBuffer& code) {
  const TileRepeats repeats(tile);
  NibbleWriter out(code.data());
  for (int at = 0; at < kTileCells;) {
    const int above = repeats.above.run(at), before = repeats.before.run(at);
    if (const int longest = std::max(above, before); longest >= kShortest) {
      put_run(out, above >= before ? kAbove : kBefore, longest);
      at += longest;
    } else {
      out.put(static_cast<std::uint32_t>(tile.levels[static_cast<std::size_t>(at++)] - kNibbleLowest), 1);
    }
  }
  return out.finish();
}

bool decode_nibbles(std::span<const std::uint8_t> code, TileCells& tile) {
  NibbleReader in(code);
  TileWriter out;
  while (out.left() > 0) {
    const std::uint32_t nibble = in.take();
    if (nibble < kAbove) {
      if (in.overrun()) return false;
      out.put(static_cast<std::int8_t>(static_cast<int>(nibble) + kNibbleLowest));
      continue;
    }
    const int length = take_length(in);
    if (in.overrun() || length < kShortest || length > out.left()) return false;
    if (nibble == kAbove) {
      out.repeat_above(length);
    } else {
      out.repeat_before(length);
    }
  }
  out.copy_to(tile);
  return in.left() == 0 || (in.left() == 1 && in.take() == 0);
}

}  // namespace cogslam
