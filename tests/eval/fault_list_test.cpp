#include "eval/fault_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/recorder.hpp"
#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

/// Two seconds in the simple room, without a camera, with these faults.
Scenario with_faults(const std::string& faults, const std::string& sensors = "{camera: {enabled: false}}") {
  return read_scenario(ConfigSection::parse("duration_s: 2\ndrive: {waypoints: [{x_m: 1, y_m: 0}]}\nsensors: " +
                                                sensors + "\nfaults:\n  - " + faults + "\n",
                                            "f.yaml"),
                       "f");
}

std::string message_of(const std::string& faults, const std::string& sensors = "{camera: {enabled: false}}") {
  return error_text([&] { with_faults(faults, sensors); });
}

TEST(FaultList, GivesEachFaultToThePartThatItSpoils) {
  const Scenario scenario = with_faults(
      "{kind: glass, from_m: [1.2, -1], to_m: [1.2, 1]}\n"
      "  - {kind: magnet, x_m: 1, y_m: 1, reach_m: 0.3, axis_deg: 90}\n"
      "  - {kind: slip_patch, x_m: 0.5, y_m: 0, radius_m: 0.4, friction: 0.1}\n"
      "  - {kind: late, sensor: lidar, latency_s: 0.2, from_s: 1}\n"
      "  - {kind: outlier_beams, share: 0.2}\n"
      "  - {kind: camera_blackout, from_s: 0.5, to_s: 1}\n"
      "  - {kind: push, at_s: 1, impulse_n_s: [1, 2]}\n"
      "  - {kind: kidnapping, at_s: 1, x_m: 0.5, y_m: 0.5, heading_deg: 90}",
      "{}");
  ASSERT_EQ(scenario.world.panes.size(), 1U);
  EXPECT_EQ(scenario.world.panes[0].b, Eigen::Vector2d(1.2, 1.0));
  ASSERT_EQ(scenario.world.magnets.size(), 1U);
  EXPECT_NEAR(scenario.world.magnets[0].axis, radians(90.0), 1e-12);
  EXPECT_EQ(scenario.world.slip_patches.size(), 1U);
  ASSERT_EQ(scenario.sensors.faults.streams.size(), 1U);
  EXPECT_EQ(scenario.sensors.faults.streams[0].latency, Duration::from_seconds(0.2));
  EXPECT_EQ(scenario.sensors.faults.streams[0].number, 3U);
  ASSERT_EQ(scenario.sensors.faults.outliers.size(), 1U);
  EXPECT_EQ(scenario.sensors.faults.outliers[0].number, 4U);
  EXPECT_EQ(scenario.camera.blackouts.back(), Eigen::Vector2d(0.5, 1.0));
  EXPECT_EQ(scenario.disturbances.pushes.size(), 1U);
  EXPECT_EQ(scenario.disturbances.kidnappings.size(), 1U);
  EXPECT_EQ(read_scenario(ConfigSection::parse(scenario.resolved, "r"), "r").resolved, scenario.resolved);
}

TEST(FaultList, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(message_of("{sensor: lidar}"), "f.yaml:5:5: a fault without 'kind', expected one as in docs/faults.md");
  EXPECT_THAT(message_of("{kind: drop_out}"), testing::HasSubstr("f.yaml:5:12: kind: expected one of dropout, frozen"));
  EXPECT_THAT(message_of("{kind: glass, to_m: [0, 1]}"), testing::HasSubstr("'from_m' is missing"));
  EXPECT_THAT(message_of("{kind: glass, from_m: [0.5, 1], to_m: [0.5, 1]}"),
              testing::HasSubstr("f.yaml:5:37: the pane ends where it begins, expected at least 0.01 m of glass"));
  EXPECT_THAT(message_of("{kind: glass, from_m: [0.5, 1], to_m: [500, 1]}"),
              testing::HasSubstr("f.yaml:5:37: with this pane the world is larger than 200 m"));
  EXPECT_THAT(message_of("{kind: frozen, sensor: camera}"),
              testing::HasSubstr("f.yaml:5:20: the robot has no such sensor, expected one that is switched on"));
  EXPECT_THAT(message_of("{kind: magnet}", "{camera: {enabled: false}, compass: {rate_hz: 0}}"),
              testing::HasSubstr("f.yaml:5:5: the robot has no such sensor"));
  EXPECT_THAT(
      message_of("{kind: kidnapping, at_s: 1, x_m: 8, y_m: 0}"),
      testing::HasSubstr("f.yaml:5:33: the robot is set down outside of the room, expected a place on its floor"));
  EXPECT_THAT(
      message_of("{kind: push, at_s: 1, impulse_n_s: [1, 0]}\n  - {kind: kidnapping, at_s: 1, x_m: 1.5, y_m: 0}"),
      testing::HasSubstr("f.yaml:6:33: the robot is set down in a wall, a box or glass"));
}

TEST(FaultList, APaneUnderTheRobotIsNoPlaceToStart) {
  EXPECT_THAT(message_of("{kind: glass, from_m: [0, -1], to_m: [0, 1]}"), testing::HasSubstr("expected room for its"));
}

TEST(FaultyDrive, IsTheSameEachTimeAndAnotherForAnotherSeed) {
  const std::string faults = "{kind: dropout, sensor: lidar, probability: 0.3}\n  - {kind: outlier_beams, share: 0.2}";
  Scenario scenario = with_faults(faults);
  const std::string once = record_drive(scenario).truth.readings_hash;
  EXPECT_EQ(record_drive(scenario).truth.readings_hash, once);
  scenario.seed = 2;
  EXPECT_NE(record_drive(scenario).truth.readings_hash, once);
}

TEST(FaultyDrive, TakesTheTruthElsewhereAndLeavesOdometryBehind) {
  const Drive drive = record_drive(with_faults("{kind: kidnapping, at_s: 1, x_m: -0.8, y_m: 0.9, heading_deg: 180}"));
  Pose2 T_map_odom;
  for (const Reading& reading : drive.recording.readings) T_map_odom = T_map_odom * reading.motion.T_before_now;
  const Pose2& truth = drive.truth.poses.back().T_map_base;
  EXPECT_GT((truth.position() - T_map_odom.position()).norm(), 0.8);
}

TEST(FaultyDrive, WithoutFaultsTheListChangesNothing) {
  Scenario plain = with_faults("{kind: dropout, sensor: lidar, probability: 0}");
  const std::string with_list = record_drive(plain).truth.readings_hash;
  plain.sensors.faults.streams.clear();
  EXPECT_EQ(record_drive(plain).truth.readings_hash, with_list);
}

}  // namespace
}  // namespace cogslam
