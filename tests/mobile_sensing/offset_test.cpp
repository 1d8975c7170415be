#include "slam/mobile_sensing/offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/rng.hpp"
#include "slam/mobile_sensing/offset_chain.hpp"
#include "tests/support/corridor.hpp"
#include "tests/support/golden.hpp"

namespace cogslam {
namespace {

constexpr GridFrame kFrame{.cell_size = 0.25, .lattice_min = {0, -32}, .width = 32, .height = 64};

/// Smooth blobs at random places, seen from `T_map_base`: a world without symmetry.
PartialMap blobs(const Pose2& T_map_base) {
  PartialMap map{Grid<double>(kFrame), Grid<double>(kFrame, 1.0)};
  for (int y = 0; y < kFrame.height; ++y) {
    for (int x = 0; x < kFrame.width; ++x) {
      const Eigen::Vector2d p = T_map_base * kFrame.centre_of({x, y});
      double sum = 0.0;
      for (std::uint32_t i = 0; i < 40; ++i) {
        Rng rng({.seed = 5, .purpose = Purpose::kWorld, .entity = i});
        const Eigen::Vector2d centre(rng.uniform(-3.0, 11.0), rng.uniform(-11.0, 11.0));
        sum += std::exp(-0.5 * (p - centre).squaredNorm() / 0.25);
      }
      map.occupancy[{x, y}] = std::min(sum, 1.0);
    }
  }
  return map;
}

void expect_near(const Pose2& a, const Pose2& b, double metres, double turn) {
  EXPECT_NEAR(a.x, b.x, metres);
  EXPECT_NEAR(a.y, b.y, metres);
  EXPECT_NEAR(a.theta, b.theta, turn);
}

/// The golden files hold 32 rows of 32 columns.
PartialMap golden_map(const std::string& name) {
  const std::vector<double> values = golden::read("golden/" + name);
  const GridFrame frame{.cell_size = 1.0, .width = static_cast<int>(values.size()) / 32, .height = 32};
  PartialMap map{Grid<double>(frame), Grid<double>(frame, 1.0)};
  map.occupancy.values() = values;
  return map;
}

TEST(Offset, MatchesTheReferencePair) {
  SKIP_WITHOUT_GOLDEN();
  const PartialMap m0 = golden_map("lk_m0_0.csv"), m1 = golden_map("lk_m1_0.csv");
  const Offset found = estimate_offset(m1, m0, {});  // m1(W(x)) = m0(x): W leads from the second map to the first
  ASSERT_TRUE(found.estimated);
  EXPECT_EQ(found.observed_directions, 3);
  const Eigen::Vector2d q(0.5 * m0.occupancy.frame().width, 16.0), d = found.T_first_second * q - q;
  EXPECT_NEAR(d.x(), 1.0, 0.02);
  EXPECT_NEAR(d.y(), -0.5, 0.02);
  EXPECT_NEAR(found.T_first_second.theta, 0.03490659, radians(0.1));
}

TEST(Offset, OfIdenticalMapsIsNone) {
  const Offset found = estimate_offset(blobs({}), blobs({}), {});
  ASSERT_TRUE(found.estimated);
  expect_near(found.T_first_second, {}, 1e-9, 1e-9);
  EXPECT_NEAR(found.rms_difference, 0.0, 1e-9);
}

TEST(Offset, FindsRandomMotions) {
  const PartialMap first = blobs({});
  for (std::uint32_t i = 0; i < 12; ++i) {
    Rng rng({.seed = 2, .purpose = Purpose::kWorld, .entity = i});
    const Pose2 truth{rng.uniform(-0.75, 0.75), rng.uniform(-0.75, 0.75), rng.uniform(-0.17, 0.17)};
    const Offset found = estimate_offset(first, blobs(truth), {});
    ASSERT_TRUE(found.estimated);
    EXPECT_EQ(found.observed_directions, 3);
    expect_near(found.T_first_second, truth, 0.05 * 0.25, radians(0.1));
  }
}

TEST(Offset, DoesNotDependOnWhereTheWorldLies) {
  const Pose2 truth{0.4, -0.3, 0.1};
  for (const Pose2& moved : {Pose2{0.07, -0.11, 0.0}, Pose2{1.0, 0.5, 0.6}, Pose2{-0.3, 0.9, -1.2}}) {
    const Offset found = estimate_offset(blobs(moved), blobs(moved * truth), {});
    ASSERT_TRUE(found.estimated);
    expect_near(found.T_first_second, truth, 0.05 * 0.25, radians(0.1));
  }
}

TEST(Offset, OfSwappedMapsIsTheInverse) {
  const Pose2 truth{0.4, -0.3, 0.1};
  const Offset there = estimate_offset(blobs({}), blobs(truth), {}),
               back = estimate_offset(blobs(truth), blobs({}), {});
  expect_near(there.T_first_second * back.T_first_second, {}, 0.01, radians(0.1));
}

TEST(Offset, AlongAStraightCorridorKeepsThePrior) {
  for (const double heading : {0.0, 0.5, -1.1}) {
    const PartialMap first = drawn_corridor(kFrame, 5.0, heading, 0.0);
    const PartialMap second = drawn_corridor(kFrame, 5.0, heading, 0.6);  // the base 0.6 cells off to the right
    const Pose2 corridor{0.0, 0.0, heading};
    const Pose2 prior{0.3 * std::cos(heading), 0.3 * std::sin(heading), 0.0};
    const Offset found = estimate_offset(first, second, prior);
    ASSERT_TRUE(found.estimated);
    EXPECT_EQ(found.observed_directions, 2) << heading;
    EXPECT_LT(found.eigenvalues[0], 0.01 * found.eigenvalues[2]);
    // The weakest direction runs along the walls.
    EXPECT_NEAR(std::abs(found.weakest.x() * std::cos(heading) + found.weakest.y() * std::sin(heading)), 1.0, 0.02);
    const Eigen::Vector2d moved = corridor.inverse() * found.T_first_second.position();
    EXPECT_NEAR(moved.x(), 0.3, 0.02) << "along: the prior";
    EXPECT_NEAR(moved.y(), -0.6 * 0.25, 0.0125) << "across: observed";
    EXPECT_NEAR(found.T_first_second.theta, 0.0, radians(0.1));
  }
}

TEST(Offset, OfEmptyMapsKeepsThePriorAndObservesNothing) {
  const PartialMap flat{Grid<double>(kFrame, 0.2), Grid<double>(kFrame, 1.0)};
  const Pose2 prior{0.3, 0.1, 0.05};
  const Offset found = estimate_offset(flat, flat, prior);
  EXPECT_TRUE(found.overlaps);
  EXPECT_FALSE(found.estimated);
  EXPECT_EQ(found.observed_directions, 0);
  EXPECT_EQ(found.T_first_second, prior);
}

TEST(Offset, WithoutOverlapKeepsThePriorAndSaysSo) {
  const Pose2 far{100.0, 0.0, 0.0};
  const Offset found = estimate_offset(blobs({}), blobs({}), far);
  EXPECT_FALSE(found.overlaps);
  EXPECT_FALSE(found.estimated);
  EXPECT_EQ(found.overlap_cells, 0.0);
  EXPECT_EQ(found.T_first_second, far);
}

TEST(OffsetChain, AddsUpMotionsFromTheStart) {
  const Pose2 start{3.0, 4.0, 1.0}, first{0.4, 0.1, 0.1}, second{0.3, -0.2, -0.05};
  OffsetChain chain({}, start);
  EXPECT_FALSE(chain.push(blobs({}), {}).has_value());
  EXPECT_EQ(chain.pose(), start);
  EXPECT_TRUE(chain.push(blobs(first), {})->estimated);
  EXPECT_TRUE(chain.push(blobs(first * second), {})->estimated);
  expect_near(chain.pose(), start * first * second, 0.03, radians(0.2));
}

TEST(OffsetConfig, SaysWhatIsInconsistent) {
  EXPECT_EQ(OffsetConfig{}.check(), "");
  EXPECT_EQ(OffsetConfig{.blur_cells = {}}.check(), "blur_cells: expected at least one pass");
  EXPECT_EQ((OffsetConfig{.blur_cells = {1.0, 0.0}}.check()), "blur_cells: expected more than 0");
  EXPECT_EQ(OffsetConfig{.iterations = 0}.check(), "iterations: expected at least 1");
  EXPECT_EQ(OffsetConfig{.stop_cells = 0.0}.check(), "stop_cells: expected more than 0");
  EXPECT_EQ(OffsetConfig{.outlier = 0.0}.check(), "outlier: expected more than 0");
  EXPECT_EQ(OffsetConfig{.prior_sigma_turn = 0.0}.check(), "prior_sigma: expected more than 0");
  EXPECT_EQ(OffsetConfig{.observable_share = 1.0}.check(), "observable_share: expected 0 or more and less than 1");
  EXPECT_EQ(OffsetConfig{.least_overlap_cells = 0}.check(), "least_overlap_cells: expected at least 1");
}

}  // namespace
}  // namespace cogslam
