#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/rng.hpp"
#include "slam/map/dense_map.hpp"
#include "slam/map/lattice.hpp"
#include "slam/map/tile_map.hpp"

// Tile maps and their plain twins, which are scanned into alike.

namespace cogslam {

inline constexpr double kCell = 0.1;

/// A map and its plain twin, which see the same commits.
struct Pair {
  TileMap tiles;
  LatticeMap twin;
};

struct World {
  explicit World(const TileStoreConfig& config = {}) : store(std::make_shared<TileStore>(tile_meter, config)) {}

  std::shared_ptr<MemoryMeter> tile_meter = std::make_shared<MemoryMeter>();
  std::shared_ptr<MemoryMeter> twin_meter = std::make_shared<MemoryMeter>();
  std::shared_ptr<TileStore> store;

  Pair empty(const std::optional<GridFrame>& area = std::nullopt) {
    return {TileMap(kCell, area, store), LatticeMap(kCell, area, twin_meter)};
  }
};

inline int draw(Rng& rng, int bound) { return static_cast<int>(rng.below(static_cast<std::uint32_t>(bound))); }

/// A scan in small: a room of free cells with walls, a few cells missed, added to what the maps hold.
inline void scan(Pair& pair, Rng& rng, const LatticeModel& model, const CellWindow& limits) {
  const Cell at{draw(rng, 400) - 200, draw(rng, 400) - 200};
  const CellWindow room{at, {at.x + 1 + draw(rng, 70), at.y + 1 + draw(rng, 70)}};
  const CellWindow changed = intersection(room, limits);
  if (changed.empty()) return;
  Grid<std::int8_t> scratch, twin_scratch;
  const CellWindow window = rng.below(2) == 0 ? whole_tiles(changed) : changed.grown(draw(rng, 9));
  pair.tiles.load(window, scratch);
  pair.twin.load(window, twin_scratch);
  ASSERT_EQ(scratch, twin_scratch);
  const Cell low = scratch.frame().lattice_min;
  for (int y = changed.min.y; y <= changed.max.y; ++y) {
    for (int x = changed.min.x; x <= changed.max.x; ++x) {
      const bool wall = x == room.min.x || x == room.max.x || y == room.min.y || y == room.max.y;
      if (rng.below(50) == 0) continue;
      std::int8_t& level = scratch[{x - low.x, y - low.y}];
      level = model.after(level, wall ? model.hit : model.free);
    }
  }
  pair.tiles.commit(scratch, changed);
  pair.twin.commit(scratch, changed);
}

inline std::uint64_t hash_of(const auto& map) {
  Hash hash;
  map.add_to(hash);
  return hash.value();
}

inline void expect_same(const Pair& pair) {
  EXPECT_EQ(pair.tiles.extent(), pair.twin.extent());
  EXPECT_EQ(hash_of(pair.tiles), hash_of(pair.twin));
  Grid<std::int8_t> scratch, twin_scratch;
  pair.tiles.load(pair.twin.extent().grown(3), scratch);
  pair.twin.load(pair.twin.extent().grown(3), twin_scratch);
  EXPECT_EQ(scratch, twin_scratch);
}

/// Adds up every piece of memory of the maps once, and compares with the meter.
inline void expect_exact_account(const std::vector<Pair>& pool, const MemoryMeter& meter) {
  std::set<const void*> counted;
  std::int64_t payload = 0, total = 0;
  for (const Pair& pair : pool) {
    pair.tiles.directory().for_each_piece([&](const void* piece, std::int64_t its_payload, std::int64_t its_total) {
      if (!counted.insert(piece).second) return;
      payload += its_payload;
      total += its_total;
    });
  }
  EXPECT_EQ(meter.payload(), payload);
  EXPECT_EQ(meter.total(), total);
}

}  // namespace cogslam
