#include "slam/map/tile_map.hpp"

#include <gmock/gmock.h>

#include "core/parallel.hpp"
#include "tests/support/tile_map_pair.hpp"

// Random use of tile maps, against their plain twins.

namespace cogslam {
namespace {

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

}  // namespace
}  // namespace cogslam
