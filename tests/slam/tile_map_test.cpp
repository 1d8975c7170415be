#include "slam/map/tile_map.hpp"

#include <gmock/gmock.h>

#include "tests/support/random_tile.hpp"
#include "tests/support/tile_map_pair.hpp"

namespace cogslam {
namespace {

TEST(TileMap, GrowsFarInEveryDirection) {
  World world;
  Pair pair = world.empty();
  Grid<std::int8_t> scratch;
  for (const Cell far : {Cell{0, 0}, Cell{-1, -1}, Cell{1000000000, 5}, Cell{-1000000000, 7}, Cell{3, 900000000},
                         Cell{4, -900000000}, Cell{-70, 40}}) {
    pair.tiles.load({far, far}, scratch);
    EXPECT_EQ(scratch.values(), std::vector<std::int8_t>{0});
    scratch[{0, 0}] = 3;
    pair.tiles.commit(scratch, {far, far});
    pair.tiles.load({far, far}, scratch);
    EXPECT_EQ(scratch.values(), std::vector<std::int8_t>{3});
  }
  EXPECT_EQ(pair.tiles.extent(), (CellWindow{{-1000000000, -900000000}, {1000000031 - 1000000000 % 32, 900000031}}));
}

TEST(TileMap, SharesAllTilesOfACopyAndCodesOnlyTheOneThatChanged) {
  World world;
  Pair pair = world.empty();
  Rng rng({.seed = 1, .purpose = Purpose::kWorld});
  for (int i = 0; i < 20; ++i) scan(pair, rng, {}, {{-300, -300}, {300, 300}});
  const std::int64_t payload = world.tile_meter->payload(), total = world.tile_meter->total();
  TileMap copy = pair.tiles;
  EXPECT_EQ(world.tile_meter->payload(), payload);
  EXPECT_EQ(world.tile_meter->total(), total);
  Grid<std::int8_t> scratch;
  copy.load({{0, 0}, {0, 0}}, scratch);
  scratch[{0, 0}] = static_cast<std::int8_t>(scratch[{0, 0}] == 8 ? 7 : scratch[{0, 0}] + 1);
  copy.commit(scratch, {{0, 0}, {0, 0}});
  EXPECT_LE(world.tile_meter->payload() - payload, 512);
  EXPECT_GT(world.tile_meter->payload(), payload);
  EXPECT_NE(hash_of(copy), hash_of(pair.tiles));
  expect_same(pair);
}

void write_tile(Pair& pair, Cell low, const TileCells& cells) {
  const CellWindow window{low, {low.x + kTileSide - 1, low.y + kTileSide - 1}};
  Grid<std::int8_t> scratch(window.frame(kCell));
  std::copy(cells.levels.begin(), cells.levels.end(), scratch.values().begin());
  pair.tiles.commit(scratch, window);
  pair.twin.commit(scratch, window);
}

TEST(TileMap, KeepsTilesFineWhereTheyHoldAnObstacleWithTwoResolutions) {
  const auto meter = std::make_shared<MemoryMeter>();
  TileMap map(kCell, std::nullopt, std::make_shared<TileStore>(meter, TileStoreConfig{.two_resolutions = true}));
  Rng rng({.seed = 3, .purpose = Purpose::kWorld});
  Grid<std::int8_t> scratch;
  const CellWindow both{{0, 0}, {2 * kTileSide - 1, kTileSide - 1}};
  map.load(both, scratch);
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < 2 * kTileSide; ++x) {
      scratch[{x, y}] = static_cast<std::int8_t>(-static_cast<int>(rng.below(5)));
    }
  }
  scratch[{3, 3}] = 2;  // an obstacle in the first tile
  const Grid<std::int8_t> written = scratch;
  map.commit(scratch, both);
  map.load(both, scratch);
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < kTileSide; ++x) {
      ASSERT_EQ((scratch[{x, y}]), (written[{x, y}]));
      const Cell second{kTileSide + x, y}, corner{kTileSide + x / 4 * 4, y / 4 * 4};
      ASSERT_EQ(scratch[second], scratch[corner]);
    }
  }
  EXPECT_LT(meter->payload(), 512 + 33);
}

int fast_tiles_in(const TileMap& map) {
  int count = 0;
  map.directory().for_each([&](Cell, const Tile& tile) { count += is_fast(tile.coding()) ? 1 : 0; });
  return count;
}

TEST(TileMap, SealsTilesOutOfUseOnceForAllThatShareThem) {
  World world;
  std::vector<Pair> pool(1, world.empty());
  Rng rng({.seed = 2, .purpose = Purpose::kWorld});
  for (int x = -64; x < 64; x += kTileSide) write_tile(pool[0], {x, 96}, noisy_wall(rng));
  pool.resize(6, pool[0]);
  const std::int64_t before = world.tile_meter->payload();
  const int fast = fast_tiles_in(pool[0].tiles);
  for (std::uint64_t now = 1; now < 8; ++now) {
    for (Pair& pair : pool) pair.tiles.settle(now);
    EXPECT_EQ(fast_tiles_in(pool[0].tiles), fast);
  }
  for (Pair& pair : pool) pair.tiles.settle(8);
  EXPECT_EQ(fast, 4);
  EXPECT_EQ(fast_tiles_in(pool[5].tiles), 0);
  EXPECT_LT(10 * world.tile_meter->payload(), 9 * before);
  expect_exact_account(pool, *world.tile_meter);
  for (Pair& pair : pool) expect_same(pair);
  scan(pool[3], rng, {}, {{-300, -300}, {300, 300}});
  for (Pair& pair : pool) expect_same(pair);
}

/// What a run holds may depend on where it has been, but not on for how long.
TEST(TileMap, DoesNotGrowInAMillionUpdates) {
  World world;
  constexpr int kUpdates = 1000000;
  std::vector<TileMap> pool(3, TileMap(kCell, std::nullopt, world.store));
  Rng rng({.seed = 4, .purpose = Purpose::kWorld});
  Grid<std::int8_t> scratch;
  std::array<std::int64_t, 2> peak{};
  for (int step = 0; step < kUpdates; ++step) {
    const std::size_t a = rng.below(3);
    const Cell at{draw(rng, 64), draw(rng, 64)};
    pool[a].load({at, at}, scratch);
    scratch[{0, 0}] = LatticeModel{}.after(scratch[{0, 0}], rng.below(3) == 0 ? 2 : -1);
    pool[a].commit(scratch, {at, at});
    if (step % 50 == 0) pool[rng.below(3)] = pool[a];
    if (step % 1000 == 0) {
      for (TileMap& map : pool) map.settle(static_cast<std::uint64_t>(step) / 1000);
    }
    std::int64_t& most = peak[step < kUpdates / 2 ? 0 : 1];
    most = std::max(most, world.tile_meter->total());
  }
  EXPECT_GT(peak[0], 1000);
  EXPECT_LE(peak[1], peak[0] + peak[0] / 20);
}

TEST(TileMap, ReturnsItsMemory) {
  World world;
  Rng rng({.seed = 5, .purpose = Purpose::kWorld});
  Pair pair = world.empty();
  for (int i = 0; i < 10; ++i) scan(pair, rng, {}, {{-300, -300}, {300, 300}});
  EXPECT_GT(world.tile_meter->total(), 0);
  const CellWindow all = pair.tiles.extent();
  Grid<std::int8_t> scratch;
  pair.tiles.load(all, scratch);
  std::fill(scratch.values().begin(), scratch.values().end(), std::int8_t{0});
  pair.tiles.commit(scratch, all);  // unknown again
  EXPECT_EQ(world.tile_meter->total(), 0);
  EXPECT_TRUE(pair.tiles.extent().empty());
}

}  // namespace
}  // namespace cogslam
