#include "slam/map/tile.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "slam/codec/byte_code.hpp"
#include "slam/codec/coarse_cells.hpp"
#include "slam/codec/context_code.hpp"
#include "slam/codec/nibble_code.hpp"

namespace cogslam {
namespace {

void* bytes_behind(Tile* tile) { return tile + 1; }

}  // namespace

Tile::Tile(TileCoding coding, std::span<const std::uint8_t> code, std::uint16_t born)
    : check_(check_sum(code)), size_(static_cast<std::uint16_t>(code.size())), born_(born), coding_(coding) {
  std::memcpy(bytes_behind(this), code.data(), code.size());
}

bool Tile::decode(TileCells& cells) const {
  if (check_sum(code()) != check_) return false;
  switch (coding_) {
    case TileCoding::kUniform:
      if (size_ != 1) return false;
      cells.levels.fill(static_cast<std::int8_t>(code()[0]));
      return true;
    case TileCoding::kNibbles:
      return decode_nibbles(code(), cells);
    case TileCoding::kBytes:
      return decode_bytes(code(), cells);
    case TileCoding::kCoarse:
      return decode_coarse(code(), cells);
    case TileCoding::kContexts:
    case TileCoding::kContextBytes:
      return decode_contexts(code(), coding_ == TileCoding::kContexts, cells);
  }
  return false;
}

// The sum of 64-bit words, each turned by its place, modulo 2^16 - 1. A changed bit changes it by a power of two, which
// is never 0 in this modulus.
std::uint16_t check_sum(std::span<const std::uint8_t> code) {
  std::uint64_t sum = code.size();
  int turn = 0;
  for (std::size_t at = 0; at < code.size(); at += 8, turn = (turn + 5) % 64) {
    std::uint64_t word = 0;
    std::memcpy(&word, code.data() + at, std::min<std::size_t>(8, code.size() - at));
    word = std::rotl(word, turn);
    sum += word;
    sum += sum < word ? 1 : 0;  // the carry: 2^64 is 1 in this modulus
  }
  return static_cast<std::uint16_t>(sum % 0xFFFF);
}

}  // namespace cogslam
