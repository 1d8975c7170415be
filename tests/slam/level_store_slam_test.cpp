#include <gmock/gmock.h>

#include "tests/support/slam_run.hpp"

// The filter with tiles, and with their plain twin.

namespace cogslam {
namespace {

void expect_same_run(const SlamConfig& tiles, const SlamConfig& twin, const SyntheticLog& log) {
  const Outcome a = run(tiles, log), b = run(twin, log);
  EXPECT_EQ(a.hash, b.hash);
  EXPECT_EQ(a.online, b.online);
  EXPECT_EQ(a.map, b.map);
  EXPECT_EQ(a.statistics.resamplings, b.statistics.resamplings);
  ASSERT_EQ(a.path.size(), b.path.size());
  for (std::size_t i = 0; i < a.path.size(); ++i) EXPECT_EQ(a.path[i].T_map_base, b.path[i].T_map_base) << i;
  EXPECT_GT(a.statistics.payload_bytes, 0.0);
  EXPECT_LT(a.statistics.bytes, b.statistics.bytes);
}

TEST(FastSlam, TakesTheSamePathToTheSameMapWithTilesAsWithTheirPlainTwin) {
  const SyntheticLog log = drive_round(100, 16);
  for (const bool grows : {false, true}) {
    for (const Proposal proposal : {Proposal::kScanMatched, Proposal::kMotion}) {
      SlamConfig tiles = config_for(log);
      tiles.proposal = proposal;
      if (grows) tiles.area.reset();
      tiles.cell_size = 0.05;
      tiles.sweep.max_hit_range = tiles.sweep.max_free_range = 1.5;  // tiles fall out of sight, and are sealed
      tiles.store = {.kind = StoreKind::kTiles, .seal_after = 1};
      SlamConfig twin = tiles;
      twin.store.kind = StoreKind::kLattice;
      SCOPED_TRACE(testing::Message() << "grows: " << grows << ", proposal " << static_cast<int>(proposal));
      expect_same_run(tiles, twin, log);
    }
  }
}

TEST(FastSlam, TakesTheSamePathToTheSameMapOnAFineLattice) {
  const SyntheticLog log = drive_round(100, 17);
  SlamConfig tiles = config_for(log);
  tiles.store = {.kind = StoreKind::kTiles, .seal_after = 2, .lattice_unit = 0.05};
  SlamConfig twin = tiles;
  twin.store.kind = StoreKind::kLattice;
  expect_same_run(tiles, twin, log);
  SlamConfig coarse = tiles;
  coarse.log_odds.hit = 1.2F;  // another model: the comparison can fail
  EXPECT_NE(run(coarse, log).hash, run(tiles, log).hash);
}

}  // namespace
}  // namespace cogslam
