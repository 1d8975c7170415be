#include "slam/map/dense_map.hpp"

#include <gmock/gmock.h>

#include "core/rng.hpp"
#include "tests/support/slow_log_odds_map.hpp"

namespace cogslam {
namespace {

constexpr double kCell = 0.1;

CellWindow random_window(Rng& rng, int around, int largest) {
  const auto draw = [&](int bound) { return static_cast<int>(rng.below(static_cast<std::uint32_t>(bound))); };
  const Cell low{draw(2 * around) - around, draw(2 * around) - around};
  return {low, {low.x + draw(largest), low.y + draw(largest)}};
}

/// A window inside another one.
CellWindow random_part(Rng& rng, const CellWindow& w) {
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(rng.below(static_cast<std::uint32_t>(high - low + 1)));
  };
  const Cell low{between(w.min.x, w.max.x), between(w.min.y, w.max.y)};
  return {low, {between(low.x, w.max.x), between(low.y, w.max.y)}};
}

void write_constant(DenseMap& map, const CellWindow& window, float value) {
  Grid<float> scratch;
  map.load(window, scratch);
  for (float& v : scratch.values()) v = value;
  map.commit(scratch, window_of(scratch.frame()));
}

struct Pair {
  DenseMap map;
  slow::LogOddsMap twin;
};

void expect_same(const Pair& pair, const CellWindow& window) {
  Grid<float> scratch;
  pair.map.load(window, scratch);
  const Cell low = scratch.frame().lattice_min;
  for (int y = 0; y < scratch.frame().height; ++y) {
    for (int x = 0; x < scratch.frame().width; ++x) {
      const Cell c{low.x + x, low.y + y};
      ASSERT_EQ((scratch[{x, y}]), pair.twin.at(c)) << c.x << " " << c.y;
    }
  }
}

void update(Pair& pair, Rng& rng, const CellWindow& limits) {
  const CellWindow window = intersection(random_window(rng, 90, 100), limits);
  if (window.empty()) return;
  Grid<float> scratch;
  pair.map.load(window, scratch);
  ASSERT_EQ(window_of(scratch.frame()), window);
  const CellWindow changed = random_part(rng, window);
  const Cell low = scratch.frame().lattice_min;
  for (int y = changed.min.y; y <= changed.max.y; ++y) {
    for (int x = changed.min.x; x <= changed.max.x; ++x) {
      if (rng.below(3) != 0) scratch[{x - low.x, y - low.y}] = static_cast<float>(rng.uniform(-2.0, 3.2));
    }
  }
  pair.map.commit(scratch, changed);
  pair.twin.commit(scratch, changed);
}

/// Particles in small: maps are written, copied over each other and dropped in random order.
void drive(const std::optional<GridFrame>& area, std::uint32_t entity) {
  Rng rng({.seed = 42, .purpose = Purpose::kWorld, .entity = entity});
  const auto meter = std::make_shared<MemoryMeter>();
  {
    const CellWindow limits = area ? window_of(*area) : CellWindow{{-1000, -1000}, {1000, 1000}};
    std::vector<Pair> pool(4, Pair{DenseMap(kCell, area, meter), {}});
    for (int step = 0; step < 120; ++step) {
      const std::size_t a = rng.below(4), b = rng.below(4);
      switch (rng.below(4)) {
        case 0:
          pool[a] = pool[b];
          break;
        case 1:
          expect_same(pool[a], random_window(rng, 120, 80));
          break;
        default:
          update(pool[a], rng, limits);
      }
      if (testing::Test::HasFatalFailure()) return;
    }
    for (const Pair& pair : pool) {
      expect_same(pair, {{-200, -200}, {200, 200}});
      const CellWindow extent = pair.map.extent();
      EXPECT_TRUE(limits.contains(extent));
      for (int y = -130; y < 230; ++y) {
        for (int x = -130; x < 230; ++x) {
          ASSERT_TRUE(pair.twin.at({x, y}) == 0.0F || extent.contains(CellWindow{{x, y}, {x, y}}));
        }
      }
    }
    EXPECT_GT(meter->payload(), 0);
  }
  EXPECT_EQ(meter->payload(), 0);
  EXPECT_EQ(meter->total(), 0);
}

TEST(DenseMap, EqualsAPlainMapOfCellsWhileItGrowsInAllDirections) {
  for (std::uint32_t round = 0; round < 6; ++round) drive(std::nullopt, round);
}

TEST(DenseMap, EqualsAPlainMapOfCellsInsideAnArea) {
  for (std::uint32_t round = 0; round < 6; ++round) {
    drive(GridFrame{.cell_size = kCell, .lattice_min = {-57, -33}, .width = 101, .height = 87}, 100 + round);
  }
}

TEST(DenseMap, IsUnknownBeforeTheFirstWrite) {
  const DenseMap map(kCell, std::nullopt, std::make_shared<MemoryMeter>());
  Grid<float> scratch;
  map.load({{-3, -4}, {40, 50}}, scratch);
  EXPECT_THAT(scratch.values(), testing::Each(0.0F));
  EXPECT_TRUE(map.extent().empty());
}

TEST(DenseMap, CutsWhatItLoadsToItsArea) {
  const GridFrame area{.cell_size = kCell, .lattice_min = {-5, -5}, .width = 10, .height = 10};
  const DenseMap map(kCell, area, std::make_shared<MemoryMeter>());
  Grid<float> scratch;
  map.load({{-100, 2}, {100, 30}}, scratch);
  EXPECT_EQ(window_of(scratch.frame()), (CellWindow{{-5, 2}, {4, 4}}));
  map.load({{50, 50}, {60, 60}}, scratch);
  EXPECT_TRUE(scratch.values().empty());
}

TEST(DenseMap, HoldsFourBytesPerCellOfItsAreaWhenAllIsWritten) {
  const auto meter = std::make_shared<MemoryMeter>();
  const GridFrame area{.cell_size = kCell, .lattice_min = {-13, -40}, .width = 70, .height = 45};
  DenseMap map(kCell, area, meter);
  write_constant(map, window_of(area), 1.0F);
  EXPECT_EQ(meter->payload(), 4 * 70 * 45);
  EXPECT_GT(meter->total(), meter->payload());
}

TEST(DenseMap, CountsSharedBlocksOnceAndWrittenOnesAnew) {
  const auto meter = std::make_shared<MemoryMeter>();
  constexpr std::int64_t kBlockBytes = 4 * DenseMap::kBlock * DenseMap::kBlock;
  DenseMap first(kCell, std::nullopt, meter);
  write_constant(first, {{-32, -32}, {31, 31}}, 1.0F);  // four whole blocks
  EXPECT_EQ(meter->payload(), 4 * kBlockBytes);
  const std::int64_t alone = meter->total();
  {
    DenseMap second = first;
    EXPECT_EQ(meter->payload(), 4 * kBlockBytes);
    EXPECT_EQ(meter->total(), alone);
    write_constant(second, {{5, 5}, {5, 5}}, 2.0F);
    EXPECT_EQ(meter->payload(), 5 * kBlockBytes);
    Grid<float> scratch;
    first.load({{5, 5}, {5, 5}}, scratch);
    EXPECT_EQ(scratch.values().front(), 1.0F);
  }
  EXPECT_EQ(meter->payload(), 4 * kBlockBytes);
  EXPECT_EQ(meter->total(), alone);
}

TEST(DenseMap, TakesNoBlockForCellsThatStayAsTheyAre) {
  const auto meter = std::make_shared<MemoryMeter>();
  DenseMap first(kCell, std::nullopt, meter);
  write_constant(first, {{0, 0}, {31, 31}}, 0.0F);
  EXPECT_EQ(meter->payload(), 0);
  write_constant(first, {{0, 0}, {31, 31}}, 1.0F);
  DenseMap second = first;
  write_constant(second, {{0, 0}, {31, 31}}, 1.0F);
  EXPECT_EQ(meter->payload(), 4 * 32 * 32);
}

TEST(DenseMap, HashesWhatItHoldsAndNotHowItGotThere) {
  const auto hash_of = [](const DenseMap& map) {
    Hash hash;
    map.add_to(hash);
    return hash.value();
  };
  const auto meter = std::make_shared<MemoryMeter>();
  DenseMap at_once(kCell, std::nullopt, meter), in_parts = at_once;
  write_constant(at_once, {{-40, 0}, {40, 10}}, 1.0F);
  write_constant(in_parts, {{0, 0}, {40, 10}}, 1.0F);
  EXPECT_NE(hash_of(at_once), hash_of(in_parts));
  write_constant(in_parts, {{-40, 0}, {-1, 10}}, 1.0F);
  EXPECT_EQ(hash_of(at_once), hash_of(in_parts));
}

}  // namespace
}  // namespace cogslam
