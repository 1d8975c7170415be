#include "slam/mobile_sensing/laser_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/rng.hpp"
#include "tests/support/slow_laser_map.hpp"

namespace cogslam {
namespace {

constexpr GridFrame kFrame{.cell_size = 0.25, .lattice_min = {0, -16}, .width = 16, .height = 32};

Scan scan_of(std::vector<float> ranges) {
  const double step = std::numbers::pi / static_cast<double>(ranges.size() - 1);
  return {
      .angle_first = -0.5 * std::numbers::pi, .angle_increment = step, .range_max = 8.0, .ranges = std::move(ranges)};
}

/// Walls, jumps, gaps and beams that say nothing.
Scan random_scan(std::uint32_t seed) {
  Rng rng({.seed = seed, .purpose = Purpose::kWorld});
  std::vector<float> ranges;
  double range = 3.0;
  for (int i = 0; i < 61; ++i) {
    if (rng.uniform() < 0.15) range = rng.uniform(0.5, 5.0);
    range = std::clamp(range + rng.uniform(-0.1, 0.1), 0.3, 6.0);
    const double kind = rng.uniform();
    ranges.push_back(kind < 0.05   ? Scan::kNoReturn
                     : kind < 0.1  ? Scan::kInvalid
                     : kind < 0.12 ? Scan::kTooClose
                                   : static_cast<float>(range));
  }
  return scan_of(std::move(ranges));
}

TEST(LaserMap, EqualsItsSlowTwinOnRandomSweeps) {
  const LaserModel model{.sigma_m = 0.12, .points_per_side = 2};
  int free = 0, occupied = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const Scan scan = random_scan(seed);
    const Pose2 T_frame_base{0.3, -0.2, 0.4 * seed};
    const Grid<double> map = scan_occupancy(model, scan, T_frame_base, kFrame);
    for (int i = 0; i < 200; ++i) {
      Rng rng({.seed = seed, .purpose = Purpose::kWorld, .entity = 1, .tick = static_cast<std::uint64_t>(i)});
      const Cell c{static_cast<int>(rng.below(16)), static_cast<int>(rng.below(32))};
      double sum = 0.0;
      for (int k = 0; k < 4; ++k) {
        const Eigen::Vector2d p = kFrame.centre_of(c) + 0.125 * Eigen::Vector2d(k % 2 - 0.5, k / 2 - 0.5);
        sum += slow::occupancy_at(model, scan, T_frame_base.inverse() * p);
      }
      EXPECT_NEAR(map[c], 0.25 * sum, 2e-4) << "seed " << seed << ", cell " << c.x << ", " << c.y;
      free += map[c] < 0.3;
      occupied += map[c] > 0.6;
    }
  }
  EXPECT_GT(free, 50);
  EXPECT_GT(occupied, 20);
}

TEST(LaserMap, IsFreeAlongABeamOccupiedAtItsEndAndUnchangedBeyond) {
  const LaserModel model{.points_per_side = 1};
  const Grid<double> map = scan_occupancy(model, scan_of(std::vector<float>(181, 2.125F)), {}, kFrame);
  EXPECT_EQ((map[{2, 16}]), model.p_free);
  EXPECT_NEAR((map[{8, 16}]), model.p_occupied, 0.2);
  EXPECT_EQ((map[{14, 16}]), kUnchanged);
}

TEST(LaserMap, WithoutReturnIsFreeUpToTheLimit) {
  const LaserModel model{.range_max_m = 2.0};
  const Grid<double> map = scan_occupancy(model, scan_of(std::vector<float>(181, Scan::kNoReturn)), {}, kFrame);
  EXPECT_NEAR((map[{6, 16}]), model.p_free, 1e-12);
  EXPECT_EQ((map[{9, 16}]), kUnchanged);
}

TEST(LaserMap, ReadingsBeyondTheLimitAreNone) {
  const LaserModel model{.range_max_m = 2.0};
  EXPECT_EQ(scan_occupancy(model, scan_of(std::vector<float>(181, 81.91F)), {}, kFrame).values(),
            scan_occupancy(model, scan_of(std::vector<float>(181, Scan::kNoReturn)), {}, kFrame).values());
}

TEST(LaserMap, SeesNothingBehind) {
  const GridFrame behind{.cell_size = 0.25, .lattice_min = {-8, -8}, .width = 5, .height = 16};
  EXPECT_EQ(scan_occupancy({}, scan_of(std::vector<float>(181, 1.5F)), {}, behind), Grid<double>(behind, kUnchanged));
}

TEST(LaserMap, AWallIsARowOfDotsWhereEndsStandAlone) {
  const std::vector<float> wall = [] {
    std::vector<float> ranges;
    for (int i = 0; i <= 180; ++i) {
      const double angle = radians(i - 90.0);  // a wall 1 m to the left
      ranges.push_back(angle > 0.01 ? static_cast<float>(1.0 / std::sin(angle)) : Scan::kNoReturn);
    }
    return ranges;
  }();
  const GridFrame far{.cell_size = 0.25, .lattice_min = {12, 3}, .width = 8, .height = 2};
  const auto least = [&](double incidence) {
    const Grid<double> map = scan_occupancy({.least_incidence = incidence}, scan_of(wall), {}, far);
    double p = 1.0;
    for (int x = 0; x < far.width; ++x) p = std::min(p, std::max(map[{x, 0}], map[{x, 1}]));
    return p;
  };
  EXPECT_GT(least(radians(7.0)), 0.6);
  EXPECT_LT(least(0.5 * std::numbers::pi), 0.59);
}

TEST(LaserMap, EvidenceAddsUpInAnyOrder) {
  Grid<double> forward(kFrame), backward(kFrame);
  for (std::uint32_t seed = 1; seed <= 4; ++seed)
    add_evidence(forward, scan_occupancy({}, random_scan(seed), {}, kFrame));
  for (std::uint32_t seed = 4; seed >= 1; --seed)
    add_evidence(backward, scan_occupancy({}, random_scan(seed), {}, kFrame));
  for (std::size_t i = 0; i < forward.values().size(); ++i) {
    EXPECT_NEAR(forward.values()[i], backward.values()[i], 1e-12);
  }
}

TEST(LaserMap, EvidenceFollowsBayes) {
  Grid<double> log_odds(kFrame), said(kFrame, 0.8);
  add_evidence(log_odds, said);
  EXPECT_NEAR((probability(log_odds)[{3, 3}]), 0.8, 1e-15);
  add_evidence(log_odds, said);
  EXPECT_NEAR((probability(log_odds)[{3, 3}]), 0.8 * 0.8 / (0.8 * 0.8 + 0.2 * 0.2), 1e-15);
}

TEST(LaserModel, SaysWhatIsInconsistent) {
  EXPECT_EQ(LaserModel{}.check(), "");
  EXPECT_EQ(LaserModel{.p_free = 0.5}.check(), "p_free: expected more than 0 and less than 0.5");
  EXPECT_EQ(LaserModel{.p_occupied = 1.0}.check(), "p_occupied: expected more than 0.5 and less than 1");
  EXPECT_EQ(LaserModel{.sigma_m = 0.0}.check(), "sigma_m: expected more than 0");
  EXPECT_EQ(LaserModel{.least_incidence = 0.0}.check(), "least_incidence: expected more than 0 and at most pi/2");
  EXPECT_EQ(LaserModel{.points_per_side = 0}.check(), "points_per_side: expected at least 1");
  EXPECT_EQ(LaserModel{.range_max_m = 0.0}.check(), "range_max_m: expected more than 0");
}

}  // namespace
}  // namespace cogslam
