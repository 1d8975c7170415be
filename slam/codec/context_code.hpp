#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "slam/codec/nibble_code.hpp"
#include "slam/codec/range_coder.hpp"
#include "slam/codec/tile_cells.hpp"

namespace cogslam {

// A dense code for tiles: a range coder whose chances depend on the neighbours that are already known. Row by row, each
// cell is told by up to three answers:
//
//   1. is it the cell above?      by the kind of the cell above, and which of six neighbours are alike
//   2. if not: the cell before?   by the kinds of both, and which of five neighbours are alike
//   3. if not: its level          four bits, each by those before it and the cell above; in tiles with other levels
//                                 than -5 to 8, eight bits of even chance
//
// The chances are the same for all tiles. They were learned from maps of the MIT CSAIL log and of two rooms
// (bench/tile_model), so they are nobody's own; a map of another kind takes more bytes, never other cells.

/// The chances of every answer.
struct ContextModel {
  static constexpr std::size_t kKinds = 7;  ///< of cells: see kind_of in context_code.cpp
  std::array<BitChance, kKinds * 64> as_above;
  std::array<BitChance, kKinds * kKinds * 8> as_before;
  std::array<BitChance, 14 * 16> level;
};

/// The model that is built in.
const ContextModel& context_model();

inline constexpr std::size_t kContextCodeMax = 1024;
using ContextBuffer = std::array<std::uint8_t, kContextCodeMax>;

/// Writes the code of a tile, and returns its length in bytes; nothing where it is longer than kContextCodeMax.
std::optional<std::size_t> encode_contexts(const TileCells& tile, bool nibbles, ContextBuffer& code);

/// Reads a code, written with the same `nibbles`: do all levels fit a nibble. False, and `tile` left open, where it
/// cannot be one. Nearly any bytes decode to something: keep a check sum.
bool decode_contexts(std::span<const std::uint8_t> code, bool nibbles, TileCells& tile);

/// Counts answers, to learn a model.
class ContextCensus {
 public:
  void add(const TileCells& tile);
  [[nodiscard]] ContextModel model() const;

 private:
  struct Count {
    double zeros = 0.4, ones = 0.4;  // as if each answer had been seen before, a little
  };
  std::array<Count, ContextModel::kKinds * 64> as_above_;
  std::array<Count, ContextModel::kKinds * ContextModel::kKinds * 8> as_before_;
  std::array<Count, 14 * 16> level_;
};

}  // namespace cogslam
