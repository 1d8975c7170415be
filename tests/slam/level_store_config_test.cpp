#include <gmock/gmock.h>

#include "slam/slam_config.hpp"
#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

SlamConfig read_text(const std::string& text) {
  ConfigSection section = ConfigSection::parse(text, "slam.yaml");
  SlamConfig config;
  read_slam_config(section, config);
  section.finish();
  config.check();
  return config;
}

std::string error_of(const std::string& text) {
  return error_text([&] { read_text(text); });
}

TEST(LevelStoreConfig, ReadsTheKeysOfTheTileStores) {
  const StoreConfig tiles = read_text("store: {kind: tiles, seal_after_scans: 3, lattice_unit: 0.05}").store;
  EXPECT_EQ(tiles.kind, StoreKind::kTiles);
  EXPECT_EQ(tiles.seal_after, 3);
  EXPECT_EQ(tiles.lattice_unit, 0.05);
  EXPECT_EQ(read_text("store: {kind: lattice}").store.kind, StoreKind::kLattice);
  EXPECT_EQ(read_text("store: {kind: two_resolution}").store.kind, StoreKind::kTwoResolution);
}

TEST(LevelStoreConfig, RefusesAModelOffTheLatticeAtItsKey) {
  EXPECT_EQ(error_of("store: {kind: tiles}\nlog_odds: {hit: 0.7}"),
            "slam.yaml:2:12: hit: expected a multiple of the store's lattice_unit 0.4, found 0.7");
  EXPECT_EQ(error_of("store: {kind: lattice, lattice_unit: 0.3}"),
            "log_odds: hit: expected a multiple of the store's lattice_unit 0.3, found 0.8");
  EXPECT_EQ(error_of("store: {kind: tiles}\nlog_odds: {clamped: false}"),
            "slam.yaml:2:12: clamped: expected true: the store keeps levels between min and max");
  EXPECT_EQ(read_text("store: {kind: dense}\nlog_odds: {hit: 0.7}").log_odds.hit, 0.7F);
}

}  // namespace
}  // namespace cogslam
