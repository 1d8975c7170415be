#include "slam/codec/context_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cogslam {
namespace {

/// Unknown; free and occupied for good; one step from unknown or from occupied; otherwise free or occupied.
constexpr std::array<std::uint8_t, 256> make_kinds() {
  std::array<std::uint8_t, 256> kinds{};
  for (int level = -128; level < 128; ++level) {
    std::uint8_t kind = level < 0 ? 3 : 4;
    if (level == 0) kind = 0;
    if (level == kNibbleLowest) kind = 1;
    if (level == kNibbleHighest) kind = 2;
    if (level == -1) kind = 5;
    if (level == kNibbleHighest - 1) kind = 6;
    kinds[static_cast<std::uint8_t>(level)] = kind;
  }
  return kinds;
}
constexpr auto kKind = make_kinds();
std::size_t kind_of(std::int8_t level) { return kKind[static_cast<std::uint8_t>(level)]; }
std::size_t bit(bool value) { return value ? 1 : 0; }

/// A cell's known neighbours: n above, w before, and so on. Outside the tile all is unknown, but the first cell of a
/// row has the one above for the one before, and the last one the one above for the one above and behind.
struct Neighbours {
  std::int8_t n, w, nw, ne, nn, ww;

  [[nodiscard]] std::size_t as_above() const {
    const std::size_t alike =
        bit(n == w) << 5 | bit(w == nw) << 4 | bit(n == ne) << 3 | bit(n == nw) << 2 | bit(nn == n) << 1 | bit(ww == w);
    return kind_of(n) * 64 + alike;
  }
  [[nodiscard]] std::size_t as_before() const {
    const std::size_t alike = bit(w == nw) << 2 | bit(ww == w) << 1 | bit(ne == n);
    return (kind_of(n) * ContextModel::kKinds + kind_of(w)) * 8 + alike;
  }
};

std::size_t nibble_of(std::int8_t level) {
  return static_cast<std::size_t>(std::clamp<int>(level, kNibbleLowest, kNibbleHighest) - kNibbleLowest);
}

/// Codes one level bit by bit; false for a nibble that is none.
template <class Answer>
bool code_level(Answer&& answer, bool nibbles, const Neighbours& near, std::int8_t& level) {
  const int bits = nibbles ? 4 : 8;
  const int value = nibbles ? level - kNibbleLowest : static_cast<std::uint8_t>(level);
  std::size_t path = 1;
  for (int b = bits - 1; b >= 0; --b) {
    const bool bit = (value >> b & 1) != 0;
    path = path << 1 | (nibbles ? answer.level(nibble_of(near.n) * 16 + path, bit) : answer.even(bit));
  }
  const int decoded = static_cast<int>(path) - (1 << bits);
  level = static_cast<std::int8_t>(nibbles ? decoded + kNibbleLowest : decoded);
  return !nibbles || decoded <= kNibbleHighest - kNibbleLowest;
}

/// Goes through the cells of a tile: an `answer` that encodes or counts reads them, one that decodes writes them.
template <class Answer>
bool code_tile(Answer&& answer, bool nibbles, std::int8_t* cells) {
  static constexpr std::array<std::int8_t, kTileSide> kUnknown{};
  for (int y = 0; y < kTileSide; ++y) {
    std::int8_t* row = cells + y * kTileSide;
    const std::int8_t* above = y > 0 ? row - kTileSide : kUnknown.data();
    const std::int8_t* above2 = y > 1 ? row - 2 * kTileSide : kUnknown.data();
    std::int8_t w = above[0], ww = w, nw = w;
    for (int x = 0; x < kTileSide; ++x) {
      const std::int8_t n = above[x];
      const Neighbours near{
          .n = n, .w = w, .nw = nw, .ne = x < kTileSide - 1 ? above[x + 1] : n, .nn = above2[x], .ww = ww};
      if (answer.as_above(near.as_above(), row[x] == n)) {
        row[x] = n;
      } else if (w != n && answer.as_before(near.as_before(), row[x] == w)) {
        row[x] = w;
      } else if (!code_level(answer, nibbles, near, row[x])) {
        return false;
      }
      ww = w;
      w = row[x];
      nw = n;
    }
  }
  return true;
}

/// Answers by a coder and the model's chances.
template <class Coder>
struct ModelAnswers {
  Coder& coder;
  const ContextModel& model = context_model();

  bool as_above(std::size_t context, bool bit) { return coder.bit(model.as_above[context], bit); }
  bool as_before(std::size_t context, bool bit) { return coder.bit(model.as_before[context], bit); }
  bool level(std::size_t context, bool bit) { return coder.bit(model.level[context], bit); }
  bool even(bool bit) { return coder.bit(1U << 15, bit); }
};

}  // namespace

std::optional<std::size_t> encode_contexts(const TileCells& tile, bool nibbles, ContextBuffer& code) {
  TileCells cells = tile;
  RangeEncoder coder(code);
  code_tile(ModelAnswers<RangeEncoder>{coder}, nibbles, cells.levels.data());
  coder.finish();
  if (coder.overflown()) return std::nullopt;
  return coder.size();
}

bool decode_contexts(std::span<const std::uint8_t> code, bool nibbles, TileCells& tile) {
  RangeDecoder coder(code);
  return code_tile(ModelAnswers<RangeDecoder>{coder}, nibbles, tile.levels.data()) && coder.took_all();
}

void ContextCensus::add(const TileCells& tile) {
  struct Counting {
    ContextCensus& census;
    static bool count(Count& count, bool bit) {
      (bit ? count.ones : count.zeros) += 1.0;
      return bit;
    }
    bool as_above(std::size_t context, bool bit) { return count(census.as_above_[context], bit); }
    bool as_before(std::size_t context, bool bit) { return count(census.as_before_[context], bit); }
    bool level(std::size_t context, bool bit) { return count(census.level_[context], bit); }
    bool even(bool bit) { return bit; }
  };
  TileCells cells = tile;
  code_tile(Counting{*this}, fits_nibbles(tile), cells.levels.data());
}

ContextModel ContextCensus::model() const {
  const auto chances = [](const auto& counts, auto& to) {
    std::transform(counts.begin(), counts.end(), to.begin(), [](const Count& count) {
      const double one = count.ones / (count.ones + count.zeros);
      return static_cast<BitChance>(std::clamp(std::lround(one * 65536.0), 16L, 65520L));
    });
  };
  ContextModel model{};
  chances(as_above_, model.as_above);
  chances(as_before_, model.as_before);
  chances(level_, model.level);
  return model;
}

}  // namespace cogslam
