#include "slam/sweep.hpp"

#include <gmock/gmock.h>

#include <numbers>

namespace cogslam {
namespace {

Reading reading_of(std::vector<float> ranges) {
  Reading reading;
  reading.scan = Scan{
      .angle_first = -0.5, .angle_increment = 0.25, .range_min = 0.1, .range_max = 20.0, .ranges = std::move(ranges)};
  return reading;
}

TEST(SweepOf, IsEmptyWithoutAScan) { EXPECT_TRUE(sweep_of(Reading{}, SweepConfig{}).empty()); }

TEST(SweepOf, LeavesOutBeamsThatSayNothing) {
  const Reading reading = reading_of({Scan::kInvalid, Scan::kTooClose, 2.0F});
  for (const bool carve : {false, true}) {
    const std::vector<Beam> beams = sweep_of(reading, {.carve_no_return = carve});
    ASSERT_EQ(beams.size(), 1U);
    EXPECT_TRUE(beams[0].hit);
    EXPECT_NEAR(beams[0].end.x(), 2.0, 1e-9);  // the third beam looks straight ahead
    EXPECT_NEAR(beams[0].end.y(), 0.0, 1e-9);
  }
}

TEST(SweepOf, CarvesABeamWithoutReturnOnlyWhereToldSo) {
  const Reading reading = reading_of({Scan::kNoReturn});
  EXPECT_TRUE(sweep_of(reading, {.carve_no_return = false}).empty());
  for (const auto& [trusted, carved] : {std::pair{12.0, 12.0}, {50.0, 20.0}}) {
    const std::vector<Beam> beams = sweep_of(reading, {.max_free_range = trusted, .carve_no_return = true});
    ASSERT_EQ(beams.size(), 1U);
    EXPECT_FALSE(beams[0].hit);
    EXPECT_NEAR((beams[0].end - beams[0].origin).norm(), carved, 1e-6);
    EXPECT_FLOAT_EQ(beams[0].range, static_cast<float>(carved));
  }
}

TEST(SweepOf, LetsFarReturnsOnlyCarve) {
  const std::vector<Beam> beams =
      sweep_of(reading_of({4.9F, 5.0F, 5.1F, 9.0F}), {.max_hit_range = 5.0, .max_free_range = 7.0});
  ASSERT_EQ(beams.size(), 4U);
  EXPECT_TRUE(beams[0].hit && beams[1].hit);
  EXPECT_FALSE(beams[2].hit || beams[3].hit);
  EXPECT_FLOAT_EQ(beams[1].range, 5.0F);
  EXPECT_FLOAT_EQ(beams[2].range, 5.1F);
  EXPECT_FLOAT_EQ(beams[3].range, 7.0F);
}

TEST(SweepOf, TurnsAndShiftsByTheMounting) {
  Reading reading = reading_of({3.0F});
  reading.scan->angle_first = 0.0;
  reading.scan->T_base_lidar = {0.2, -0.1, std::numbers::pi / 2.0};
  const std::vector<Beam> beams = sweep_of(reading, {});
  EXPECT_NEAR((beams[0].origin - Eigen::Vector2d(0.2, -0.1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((beams[0].end - Eigen::Vector2d(0.2, 2.9)).norm(), 0.0, 1e-6);
  EXPECT_FLOAT_EQ(beams[0].range, 3.0F);
}

/// A straight wall 4 m ahead, seen from a base that drives and turns while the lidar sweeps.
TEST(SweepOf, TakesTheMotionWithinTheSweepOut) {
  constexpr double kWall = 4.0;
  Reading reading;
  reading.stamp = Time{};
  Scan scan{.angle_first = -0.6,
            .angle_increment = 0.01,
            .range_min = 0.1,
            .range_max = 30.0,
            .time_increment = Duration{200'000},  // 24 ms for the sweep
            .T_base_lidar = {0.15, 0.05, 0.1},
            .ranges = {}};
  for (const Twist2& twist : {Twist2{}, Twist2{0.8, 0.0, 0.0}, Twist2{0.0, 0.0, 2.0}, Twist2{1.0, -0.5, -3.0}}) {
    scan.ranges.clear();
    double worst_untreated = 0.0;
    for (int i = 0; i < 120; ++i) {
      const double t = i * 200e-6;
      const Pose2 T_map_lidar = Pose2::exp(t * twist) * scan.T_base_lidar;
      const double angle = scan.angle_first + i * scan.angle_increment;
      const double range = (kWall - T_map_lidar.x) / std::cos(T_map_lidar.theta + angle);
      scan.ranges.push_back(static_cast<float>(range));
      const Eigen::Vector2d untreated =
          scan.T_base_lidar * Eigen::Vector2d(range * std::cos(angle), range * std::sin(angle));
      worst_untreated = std::max(worst_untreated, std::abs(untreated.x() - kWall));
    }
    reading.scan = scan;
    reading.twist = twist;
    const std::vector<Beam> beams = sweep_of(reading, {});
    ASSERT_EQ(beams.size(), 120U);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      EXPECT_NEAR(beams[i].end.x(), kWall, 1e-5);
      EXPECT_NEAR(beams[i].range, (beams[i].end - beams[i].origin).norm(), 1e-5);
      const Pose2 T_base_then = Pose2::exp(static_cast<double>(i) * 200e-6 * twist);
      EXPECT_NEAR((beams[i].origin - T_base_then * scan.T_base_lidar.position()).norm(), 0.0, 1e-12);
    }
    if (twist != Twist2{}) {
      EXPECT_GT(worst_untreated, 0.01);
    }
  }
}

}  // namespace
}  // namespace cogslam
