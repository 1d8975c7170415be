#pragma once

#include <array>
#include <cstdint>

namespace cogslam {

inline constexpr int kTileSide = 32;  ///< cells
inline constexpr int kTileCells = kTileSide * kTileSide;

/// The cells of a tile in plain form: levels, row-major.
struct alignas(16) TileCells {
  std::array<std::int8_t, kTileCells> levels{};

  bool operator==(const TileCells&) const = default;
};

}  // namespace cogslam
