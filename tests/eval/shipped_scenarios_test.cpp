#include <gtest/gtest.h>

#include "eval/recorder.hpp"
#include "worlds/clearance.hpp"

namespace cogslam {
namespace {

constexpr double kBodyRadius = 0.284;  // of the vehicle's footprint, about its centre [m]

/// The drive alone: what the sensors see does not change it, so few of them look.
Scenario shipped(const std::string& name) {
  return load_scenario(std::filesystem::path(COGSLAM_SOURCE_DIR) / "scenarios" / (name + ".yaml"),
                       {{"sensors.camera.enabled", "false"}, {"sensors.lidar.beams", "2"}});
}

class ShippedScenario : public testing::TestWithParam<const char*> {};

TEST_P(ShippedScenario, DrivesItsLoopWithoutTouchingAnything) {
  const Scenario scenario = shipped(GetParam());
  EXPECT_NEAR(scenario.duration.seconds(), 60.0, 5.0);
  const Drive drive = record_drive(scenario);
  EXPECT_FALSE(drive.stuck);
  double way = 0.0, turned = 0.0, nearest_end = 1e9;
  Pose2 before = scenario.world.start;
  for (const TruePose& pose : drive.truth.poses) {
    EXPECT_GT(clearance(drive.truth.world, pose.T_map_base.position()), kBodyRadius) << pose.stamp.seconds() << " s";
    way += (pose.T_map_base.position() - before.position()).norm();
    turned += std::abs(angle_difference(pose.T_map_base.theta, before.theta));
    before = pose.T_map_base;
    if (way < 10.0) continue;
    nearest_end = std::min(nearest_end, (before.position() - scenario.world.start.position()).norm());
  }
  EXPECT_GT(way, 15.0);
  EXPECT_GT(turned, radians(300.0));
  EXPECT_LT(nearest_end, 0.05) << "the loop is closed before the run ends";
}

TEST_P(ShippedScenario, ComparesBothStoresAtFourCellSizes) {
  const Scenario scenario = shipped(GetParam());
  EXPECT_EQ(scenario.name, GetParam());
  ASSERT_EQ(scenario.variants.size(), 16U);
  const std::vector<double> sizes{1.0, 0.5, 0.2, 0.1};
  for (std::size_t i = 0; i < 16; ++i) {
    const VariantConfig& variant = scenario.variants[i];
    EXPECT_EQ(variant.slam.cell_size, sizes[i / 4]);
    EXPECT_EQ(variant.slam.particles, 100);
    EXPECT_EQ(variant.slam.store.kind, i % 2 == 0 ? StoreKind::kDense : StoreKind::kCoefficients);
    EXPECT_EQ(variant.true_poses, i % 4 >= 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Rooms, ShippedScenario, testing::Values("simple", "cornered", "cluttered"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(ShippedHallway, DrivesFromTheLowerHallwayRoundACornerWithoutTouchingAnything) {
  const Scenario scenario = shipped("hallway");
  EXPECT_EQ(scenario.name, "hallway");
  const Drive drive = record_drive(scenario);
  EXPECT_FALSE(drive.stuck);
  double way = 0.0;
  Eigen::Vector2d before = scenario.world.start.position();
  for (const TruePose& pose : drive.truth.poses) {
    EXPECT_GT(clearance(drive.truth.world, pose.T_map_base.position()), kBodyRadius) << pose.stamp.seconds() << " s";
    way += (pose.T_map_base.position() - before).norm();
    before = pose.T_map_base.position();
  }
  EXPECT_GT(way, 40.0);
  EXPECT_GT(before.y(), scenario.world.start.y + 10.0) << "the corner was turned";
}

TEST(ShippedFlat, DrivesThroughTheDoorsOfAMapWithoutTouchingAnything) {
  const Scenario scenario = shipped("flat");
  ASSERT_NE(scenario.world.map, nullptr);
  const Drive drive = record_drive(scenario);
  EXPECT_FALSE(drive.stuck);
  double way = 0.0, lowest = 1e9, highest = -1e9;
  Eigen::Vector2d before = scenario.world.start.position();
  for (const TruePose& pose : drive.truth.poses) {
    const Eigen::Vector2d p_map = pose.T_map_base.position();
    EXPECT_GT(clearance(drive.truth.world, p_map), kBodyRadius) << pose.stamp.seconds() << " s";
    way += (p_map - before).norm();
    lowest = std::min(lowest, p_map.y());
    highest = std::max(highest, p_map.y());
    before = p_map;
  }
  EXPECT_GT(way, 15.0);
  EXPECT_LT(lowest, 2.5) << "in the rooms below the corridor";
  EXPECT_GT(highest, 6.0) << "and in one above it";
}

TEST(ResolvedScenario, LoadsAsItself) {
  const Scenario scenario = shipped("cluttered");
  EXPECT_EQ(read_scenario(ConfigSection::parse(scenario.resolved, "resolved"), "other").resolved, scenario.resolved);
}

}  // namespace
}  // namespace cogslam
