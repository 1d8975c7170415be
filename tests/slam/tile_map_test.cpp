#include "slam/map/tile_map.hpp"

#include <gmock/gmock.h>

#include <set>

#include "core/parallel.hpp"
#include "core/rng.hpp"
#include "slam/map/dense_map.hpp"
#include "slam/map/lattice.hpp"
#include "tests/support/random_tile.hpp"

namespace cogslam {
namespace {

constexpr double kCell = 0.1;

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

int draw(Rng& rng, int bound) { return static_cast<int>(rng.below(static_cast<std::uint32_t>(bound))); }

/// A scan in small: a room of free cells with walls, a few cells missed, added to what the maps hold.
void scan(Pair& pair, Rng& rng, const LatticeModel& model, const CellWindow& limits) {
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

std::uint64_t hash_of(const auto& map) {
  Hash hash;
  map.add_to(hash);
  return hash.value();
}

void expect_same(const Pair& pair) {
  EXPECT_EQ(pair.tiles.extent(), pair.twin.extent());
  EXPECT_EQ(hash_of(pair.tiles), hash_of(pair.twin));
  Grid<std::int8_t> scratch, twin_scratch;
  pair.tiles.load(pair.twin.extent().grown(3), scratch);
  pair.twin.load(pair.twin.extent().grown(3), twin_scratch);
  EXPECT_EQ(scratch, twin_scratch);
}

/// Adds up every piece of memory of the maps once, and compares with the meter.
void expect_exact_account(const std::vector<Pair>& pool, const MemoryMeter& meter) {
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

/// Particles in small: maps are scanned into, copied over each other and dropped in random order.
void drive(const LatticeModel& model, const std::optional<GridFrame>& area, std::uint32_t entity, int seal_after = 8) {
  Rng rng({.seed = 7, .purpose = Purpose::kWorld, .entity = entity});
  World world({.seal_after = seal_after});
  const CellWindow limits = area ? window_of(*area) : CellWindow{{-100000, -100000}, {100000, 100000}};
  {
    std::vector<Pair> pool(5, world.empty(area));
    for (int step = 0; step < 150; ++step) {
      const std::size_t a = rng.below(5), b = rng.below(5);
      switch (rng.below(6)) {
        case 0:
          pool[a] = pool[b];
          break;
        case 1:
          if (rng.below(4) == 0) pool[a] = world.empty(area);
          break;
        default:
          scan(pool[a], rng, model, limits);
      }
      for (Pair& pair : pool) pair.tiles.settle(static_cast<std::uint64_t>(step));
      if (step % 10 == 0) expect_exact_account(pool, *world.tile_meter);
      if (testing::Test::HasFatalFailure()) return;
    }
    for (const Pair& pair : pool) expect_same(pair);
    expect_exact_account(pool, *world.tile_meter);
    EXPECT_GT(world.tile_meter->payload(), 0);
    EXPECT_LT(world.tile_meter->total(), world.twin_meter->total());
  }
  EXPECT_EQ(world.tile_meter->payload(), 0);
  EXPECT_EQ(world.tile_meter->total(), 0);
}

TEST(TileMap, EqualsItsPlainTwinWhileMapsAreScannedCopiedAndDropped) {
  for (std::uint32_t round = 0; round < 8; ++round) drive({}, std::nullopt, round);
}

TEST(TileMap, EqualsItsPlainTwinInsideAnArea) {
  const GridFrame area{.cell_size = kCell, .lattice_min = {-57, -33}, .width = 201, .height = 187};
  for (std::uint32_t round = 0; round < 4; ++round) drive({}, area, 100 + round);
}

TEST(TileMap, EqualsItsPlainTwinOnAFineLattice) {
  const LatticeModel fine{.unit = 0.05, .hit = 16, .free = -8, .min = -40, .max = 64};
  for (std::uint32_t round = 0; round < 4; ++round) drive(fine, std::nullopt, 200 + round);
}

TEST(TileMap, EqualsItsPlainTwinWhenItSealsAtOnceOrSoon) {
  for (const int scans : {0, 1}) {
    for (std::uint32_t round = 0; round < 4; ++round) drive({}, std::nullopt, 300 + round, scans);
  }
}

/// Eight maps that share their past are scanned into at once, settled and shared anew; returns their hash and bytes.
std::pair<std::uint64_t, std::int64_t> run_with(int threads) {
  World world;
  Workers workers(threads);
  std::vector<Pair> pool(8, world.empty());
  for (std::uint32_t step = 0; step < 40; ++step) {
    workers.for_each(pool.size(), [&](std::size_t p, int) {
      Rng rng({.seed = step, .purpose = Purpose::kWorld, .entity = static_cast<std::uint32_t>(p / 2)});
      scan(pool[p], rng, {}, {{-300, -300}, {300, 300}});
    });
    for (Pair& pair : pool) pair.tiles.settle(step);
    if (step % 3 == 0) pool[step % 8] = pool[(step + 5) % 8];
  }
  Hash hash;
  for (const Pair& pair : pool) pair.tiles.add_to(hash);
  return {hash.value(), world.tile_meter->total()};
}

TEST(TileMap, IsTheSameFromAnyNumberOfThreads) {
  const auto alone = run_with(1);
  EXPECT_EQ(run_with(2), alone);
  EXPECT_EQ(run_with(5), alone);
}

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
