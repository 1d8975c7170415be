#include "slam/mobile_sensing/partial_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

/// A wall across a free field, nothing known behind it.
PartialMap walled_map() {
  const PartialMapConfig config;
  Grid<double> p(config.frame(), 0.2);
  for (int y = 0; y < 64; ++y) {
    p[{20, y}] = 0.9;
    for (int x = 21; x < 32; ++x) p[{x, y}] = kUnchanged;
  }
  return with_weights(std::move(p));
}

TEST(PartialMap, LiesAheadOfTheBaseHalfToEitherSide) {
  const GridFrame frame = PartialMapConfig{}.frame();
  EXPECT_EQ(frame.width, 32);
  EXPECT_EQ(frame.height, 64);
  EXPECT_EQ(frame.origin(), Eigen::Vector2d(0.0, -8.0));
}

TEST(PartialMap, CountsWhatIsKnownAndTheFarSideOfWalls) {
  const PartialMap map = walled_map();
  EXPECT_EQ((map.weight[{5, 30}]), 1.0);
  EXPECT_EQ((map.weight[{20, 30}]), 1.0);
  EXPECT_EQ((map.weight[{21, 30}]), 1.0);
  EXPECT_EQ((map.weight[{22, 30}]), 0.0);
}

TEST(PartialMap, DoesNotCountWhereTheViewEndsInFreeCells) {
  Grid<double> p(PartialMapConfig{}.frame(), kUnchanged);
  p[{5, 5}] = 0.2;
  const PartialMap map = with_weights(std::move(p));
  EXPECT_EQ(std::count(map.weight.values().begin(), map.weight.values().end(), 1.0), 1);
}

TEST(PartialMap, ComesBackAsItIsFromAllItsCells) {
  const PartialMap map = walled_map();
  EXPECT_EQ(recover_from_samples(map, 2048, 1, 0).occupancy, map.occupancy);
}

TEST(PartialMap, KeepsTheSampledCellsAndComesNearTheOthers) {
  const PartialMap map = walled_map(), recovered = recover_from_samples(map, 1024, 1, 0);
  int same = 0;
  double squares = 0.0;
  for (std::size_t i = 0; i < 2048; ++i) {
    const double d = recovered.occupancy.values()[i] - map.occupancy.values()[i];
    same += d == 0.0 ? 1 : 0;
    squares += d * d;
  }
  EXPECT_GE(same, 1024);
  EXPECT_LT(squares / 2048.0, 0.004);
}

TEST(PartialMap, SamplesOtherCellsForAnotherIndexAndTheSameForTheSame) {
  const PartialMap map = walled_map();
  const auto recovered = [&](std::uint32_t index) { return recover_from_samples(map, 300, 1, index).occupancy; };
  EXPECT_EQ(recovered(0), recovered(0));
  EXPECT_NE(recovered(0), recovered(1));
}

TEST(PartialMap, RefusesMoreSamplesThanCellsAndNone) {
  const PartialMap map = walled_map();
  EXPECT_EQ(error_text([&] { (void)recover_from_samples(map, 2049, 1, 0); }),
            "samples: expected 1 to 2048, the cells of a partial map, found 2049");
  EXPECT_EQ(error_text([&] { (void)recover_from_samples(map, 0, 1, 0); }),
            "samples: expected 1 to 2048, the cells of a partial map, found 0");
}

TEST(PartialMapConfig, SaysWhatIsInconsistent) {
  EXPECT_EQ(PartialMapConfig{}.check(), "");
  EXPECT_EQ(PartialMapConfig{.across_cells = 0}.check(), "across_cells: expected at least 1, found 0");
  EXPECT_EQ(PartialMapConfig{.ahead_cells = -3}.check(), "ahead_cells: expected at least 1, found -3");
  EXPECT_EQ(PartialMapConfig{.cell_size_m = 0.0}.check(), "cell_size_m: expected more than 0");
}

}  // namespace
}  // namespace cogslam
