#include "slam/mobile_sensing/stitch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cogslam {
namespace {

constexpr GridFrame kMap{.cell_size = 0.25, .lattice_min = {-40, -40}, .width = 80, .height = 80};

PartialMap one_wall_cell() {
  Grid<double> p(PartialMapConfig{}.frame(), kUnchanged);
  p[{4, 33}] = 0.9;  // centre (1.125, 0.375)
  PartialMap map = with_weights(std::move(p));
  return map;
}

TEST(Stitch, PutsACellWhereItsPoseSays) {
  Grid<double> log_odds(kMap);
  stitch(log_odds, one_wall_cell(), {2.0, 1.0, 0.5 * std::numbers::pi});
  const Cell there = kMap.cell_of({2.0 - 0.375, 1.0 + 1.125});
  EXPECT_NEAR(log_odds[there], std::log(9.0), 1e-12);
  double all = 0.0;
  for (const double l : log_odds.values()) all += std::abs(l);
  EXPECT_NEAR(all, std::log(9.0), 1e-12);
}

TEST(Stitch, AddsUpEvidenceInAnyOrder) {
  Grid<double> forward(kMap), backward(kMap);
  const Pose2 a{0.1, 0.2, 0.3}, b{-0.2, 0.1, 0.25};
  stitch(forward, one_wall_cell(), a);
  stitch(forward, one_wall_cell(), b);
  stitch(backward, one_wall_cell(), b);
  stitch(backward, one_wall_cell(), a);
  EXPECT_EQ(forward, backward);
}

TEST(Stitch, LosesWhatLiesOutsideTheMap) {
  Grid<double> log_odds(kMap);
  stitch(log_odds, one_wall_cell(), {500.0, 0.0, 0.0});
  EXPECT_EQ(log_odds, Grid<double>(kMap));
}

TEST(Stitch, KeepsCertainCellsFinite) {
  Grid<double> log_odds(kMap);
  stitch(log_odds, with_weights(Grid<double>(PartialMapConfig{}.frame(), 1.0)), {});
  for (const double l : log_odds.values()) EXPECT_TRUE(std::isfinite(l));
}

}  // namespace
}  // namespace cogslam
