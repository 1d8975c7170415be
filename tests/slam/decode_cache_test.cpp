#include "slam/map/decode_cache.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <new>

#include "core/parallel.hpp"
#include "slam/codec/nibble_code.hpp"
#include "tests/support/random_tile.hpp"

namespace cogslam {
namespace {

/// A tile in memory of its own, and what it should decode to.
struct Kept {
  std::vector<std::uint64_t> memory;
  TileCells cells;

  explicit Kept(Rng& rng) : cells(random_tile(rng, kNibbleLowest, kNibbleHighest)) {
    NibbleBuffer code;
    const std::size_t size = encode_nibbles(cells, code);
    memory.resize((sizeof(Tile) + size + 7) / 8);
    new (memory.data()) Tile(TileCoding::kNibbles, {code.data(), size}, 0);
  }
  [[nodiscard]] const Tile& tile() const { return *std::launder(reinterpret_cast<const Tile*>(memory.data())); }
  void damage() { reinterpret_cast<std::uint8_t*>(memory.data())[sizeof(Tile)] ^= 1; }
};

std::vector<Kept> some_tiles(int count) {
  Rng rng({.seed = 9, .purpose = Purpose::kWorld});
  std::vector<Kept> tiles;
  for (int i = 0; i < count; ++i) tiles.emplace_back(rng);
  return tiles;
}

bool gives(DecodeCache& cache, const Kept& kept) {
  bool same = false;
  cache.with(kept.tile(),
             [&](const std::int8_t* cells) { same = std::memcmp(cells, kept.cells.levels.data(), kTileCells) == 0; });
  return same;
}

TEST(DecodeCache, GivesTheCellsOfFarMoreTilesThanItHolds) {
  DecodeCache cache(16);
  const std::vector<Kept> tiles = some_tiles(100);
  Rng rng({.seed = 10, .purpose = Purpose::kWorld});
  for (int i = 0; i < 3000; ++i) {
    const Kept& kept = tiles[rng.below(100)];
    if (rng.below(5) == 0) cache.put(kept.tile(), kept.cells);
    if (rng.below(9) == 0) cache.forget(kept.tile());
    ASSERT_TRUE(gives(cache, kept));
  }
}

TEST(DecodeCache, DecodesATileOnceWhileItHoldsIt) {
  DecodeCache cache(16);
  std::vector<Kept> tiles = some_tiles(1);
  EXPECT_TRUE(gives(cache, tiles[0]));
  tiles[0].damage();
  EXPECT_TRUE(gives(cache, tiles[0]));  // as decoded before
  cache.forget(tiles[0].tile());
  EXPECT_THROW(gives(cache, tiles[0]), std::runtime_error);
}

TEST(DecodeCache, ServesSeveralThreads) {
  DecodeCache cache(8);
  const std::vector<Kept> tiles = some_tiles(40);
  std::vector<int> wrong(2000);
  Workers workers(4);
  workers.for_each(wrong.size(), [&](std::size_t i, int) { wrong[i] = gives(cache, tiles[i % 40]) ? 0 : 1; });
  EXPECT_THAT(wrong, testing::Each(0));
}

}  // namespace
}  // namespace cogslam
