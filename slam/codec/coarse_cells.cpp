#include "slam/codec/coarse_cells.hpp"

#include <algorithm>

#include "slam/codec/nibble_code.hpp"

namespace cogslam {
namespace {

constexpr int kPerSide = kTileSide / kCoarseSide;
constexpr int kCellsEach = kCoarseSide * kCoarseSide;

/// Calls visit(i) with the index of every cell of a coarse cell.
template <class Visit>
void for_each_cell_of(int coarse, Visit&& visit) {
  const int first = coarse / kPerSide * kCoarseSide * kTileSide + coarse % kPerSide * kCoarseSide;
  for (int y = 0; y < kCoarseSide; ++y) {
    for (int x = 0; x < kCoarseSide; ++x) visit(static_cast<std::size_t>(first + y * kTileSide + x));
  }
}

void fill(TileCells& tile, int coarse, int level) {
  for_each_cell_of(coarse, [&](std::size_t i) { tile.levels[i] = static_cast<std::int8_t>(level); });
}

}  // namespace

bool nothing_above(const TileCells& tile, std::int8_t highest) {
  return *std::max_element(tile.levels.begin(), tile.levels.end()) <= highest;
}

void coarsen(TileCells& tile) {
  for (int coarse = 0; coarse < kPerSide * kPerSide; ++coarse) {
    int sum = 0;
    for_each_cell_of(coarse, [&](std::size_t i) { sum += tile.levels[i]; });
    fill(tile, coarse, (sum + (sum < 0 ? -kCellsEach / 2 : kCellsEach / 2)) / kCellsEach);
  }
}

std::array<std::uint8_t, kCoarseCodeBytes> encode_coarse(const TileCells& tile) {
  std::array<std::uint8_t, kCoarseCodeBytes> code{};
  for (int coarse = 0; coarse < kPerSide * kPerSide; ++coarse) {
    const int first = coarse / kPerSide * kCoarseSide * kTileSide + coarse % kPerSide * kCoarseSide;
    const int nibble = tile.levels[static_cast<std::size_t>(first)] - kNibbleLowest;
    code[static_cast<std::size_t>(coarse) / 2] |= static_cast<std::uint8_t>(nibble << (coarse % 2 * 4));
  }
  return code;
}

bool decode_coarse(std::span<const std::uint8_t> code, TileCells& tile) {
  if (code.size() != kCoarseCodeBytes) return false;
  for (int coarse = 0; coarse < kPerSide * kPerSide; ++coarse) {
    const int nibble = code[static_cast<std::size_t>(coarse) / 2] >> (coarse % 2 * 4) & 15;
    if (nibble > kNibbleHighest - kNibbleLowest) return false;
    fill(tile, coarse, nibble + kNibbleLowest);
  }
  return true;
}

}  // namespace cogslam
