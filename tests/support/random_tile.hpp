#pragma once

#include <algorithm>

#include "core/rng.hpp"
#include "slam/codec/tile_cells.hpp"

namespace cogslam {

/// Tiles of every character: noise, blobs, stripes, walls in free space, near-empty ones. Levels in [lowest, highest].
inline TileCells random_tile(Rng& rng, int lowest, int highest) {
  const auto level = [&] {
    return static_cast<std::int8_t>(lowest +
                                    static_cast<int>(rng.below(static_cast<std::uint32_t>(highest - lowest + 1))));
  };
  TileCells tile;
  const std::uint32_t kind = rng.below(6);
  const std::int8_t ground = rng.below(2) == 0 ? std::int8_t{0} : level();
  tile.levels.fill(ground);
  for (int y = 0; y < kTileSide; ++y) {
    const std::int8_t in_row = level();
    for (int x = 0; x < kTileSide; ++x) {
      std::int8_t& cell = tile.levels[static_cast<std::size_t>(y * kTileSide + x)];
      if (kind == 0) cell = level();
      if (kind == 1 && rng.below(4) == 0) cell = level();
      if (kind == 2) cell = in_row;
      if (kind == 3 && (x + 2 * y) % 13 < 2) cell = level();
      if (kind == 4 && x % 8 == 0) cell = in_row;
    }
  }
  if (kind == 5) tile.levels[rng.below(kTileCells)] = level();
  return tile;
}

/// Free space before a wall, blurred as scans leave it, with the unknown behind.
inline TileCells noisy_wall(Rng& rng) {
  TileCells tile;
  for (int y = 0; y < kTileSide; ++y) {
    const int wall = 14 + y / 12;
    for (int x = 0; x <= wall; ++x) {
      const int noise = static_cast<int>(rng.below(3));
      tile.levels[static_cast<std::size_t>(y * kTileSide + x)] =
          static_cast<std::int8_t>(x == wall ? 8 - noise : (x == wall - 1 ? noise - 5 : -5));
    }
  }
  return tile;
}

}  // namespace cogslam
