#include "slam/map/tile.hpp"

#include <cstring>

#include "slam/codec/byte_code.hpp"
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
  }
  return false;
}

std::uint16_t check_sum(std::span<const std::uint8_t> code) {
  std::uint64_t sum = 0x9e3779b97f4a7c15ULL ^ code.size();
  std::size_t at = 0;
  for (; at + 8 <= code.size(); at += 8) {
    std::uint64_t word;
    std::memcpy(&word, code.data() + at, 8);
    sum = (sum ^ word) * 0xff51afd7ed558ccdULL;
    sum ^= sum >> 32;
  }
  std::uint64_t word = 0;
  for (; at < code.size(); ++at) word = word << 8 | code[at];
  sum = (sum ^ word) * 0xff51afd7ed558ccdULL;
  return static_cast<std::uint16_t>(sum >> 48);
}

}  // namespace cogslam
