#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "sim/drive_config.hpp"
#include "sim/robot_config.hpp"

namespace cogslam {
namespace {

RobotConfig robot(const std::string& text) {
  ConfigSection section = ConfigSection::parse(text, "robot.yaml");
  const RobotConfig config = read_robot_config(section);
  section.finish();
  return config;
}

DriveConfig route(const std::string& text) {
  ConfigSection section = ConfigSection::parse(text, "drive.yaml");
  const DriveConfig config = read_drive_config(section);
  section.finish();
  return config;
}

template <class Read>
std::string error_of(Read read, const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RobotConfig, HasSoundDefaults) {
  EXPECT_NO_THROW(RobotConfig{}.check());
  const RobotConfig config = robot("mass_kg: 8\n");
  EXPECT_EQ(config.mass, 8.0);
  EXPECT_EQ(config.motor.kp, RobotConfig{}.motor.kp);
  EXPECT_EQ(config.step, Duration::from_seconds(0.001));
}

TEST(RobotConfig, ReadsEveryPart) {
  const RobotConfig config = robot(
      "wheel_radius_m: 0.07\nhalf_length_m: 0.2\nhalf_width_m: 0.169\nlength_m: 0.6\nwidth_m: 0.5\nstep_ms: 5\n"
      "motor: {kp_n_m_s_per_rad: 0.05, max_speed_rad_s: 9}\nroughness: {rolling: 0, grip: 0.2, length_m: 0.1}\n");
  EXPECT_EQ(config.geometry.arm(), 0.369);
  EXPECT_EQ(config.length, 0.6);
  EXPECT_EQ(config.step.ns, 5'000'000);
  EXPECT_EQ(config.motor.max_speed, 9.0);
  EXPECT_EQ(config.roughness.rolling, 0.0);
  EXPECT_EQ(config.roughness.length, 0.1);
}

TEST(RobotConfig, RejectsWhatDoesNotGoTogether) {
  EXPECT_THAT(error_of(robot, "half_width_m: 0.3\n"), testing::HasSubstr("the wheels stand outside the footprint"));
  EXPECT_THAT(error_of(robot, "step_ms: 15\n"), testing::HasSubstr("the motor gain is too high for the physics step"));
  EXPECT_THAT(error_of(robot, "mass_kg: 0\n"), testing::StartsWith("robot.yaml:1:"));
  EXPECT_THAT(error_of(robot, "mass: 3\n"), testing::HasSubstr("mass"));
}

TEST(DriveConfig, ReadsEveryKindOfLeg) {
  const DriveConfig config = route(
      "speed_m_s: 0.5\nwaypoints:\n  - {x_m: 1, y_m: 2}\n  - {x_m: 1, y_m: 3, heading: keep}\n"
      "  - {x_m: 0, y_m: 3, heading: face, heading_deg: 90}\n"
      "  - {x_m: 0, y_m: 0, heading: turn, turn_rate_deg_s: -20}\n");
  ASSERT_EQ(config.waypoints.size(), 4U);
  EXPECT_EQ(config.speed, 0.5);
  EXPECT_EQ(config.waypoints[0].p_map, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(config.waypoints[0].mode, LegHeading::kAlong);
  EXPECT_EQ(config.waypoints[1].mode, LegHeading::kKeep);
  EXPECT_DOUBLE_EQ(config.waypoints[2].heading, radians(90.0));
  EXPECT_DOUBLE_EQ(config.waypoints[3].turn_rate, radians(-20.0));
}

TEST(DriveConfig, ReadsAScript) {
  const DriveConfig config = route("kind: script\nscript:\n  - {duration_s: 2.5, vx_m_s: 0.3, omega_deg_s: 90}\n");
  ASSERT_EQ(config.script.size(), 1U);
  EXPECT_EQ(config.script[0].duration, Duration::from_seconds(2.5));
  EXPECT_EQ(config.script[0].twist.x, 0.3);
  EXPECT_DOUBLE_EQ(config.script[0].twist.theta, radians(90.0));
}

TEST(DriveConfig, SaysWhatIsMissing) {
  EXPECT_THAT(error_of(route, "speed_m_s: 0.3\n"), testing::HasSubstr("nowhere to drive, expected a list of"));
  EXPECT_THAT(error_of(route, "kind: script\n"), testing::HasSubstr("nothing to drive, expected a list of"));
  EXPECT_THAT(error_of(route, "waypoints:\n  - {x_m: 1}\n"), testing::HasSubstr("'y_m' is missing, expected a number"));
  EXPECT_THAT(error_of(route, "waypoints:\n  - {x_m: 1, y_m: 1, heading: face}\n"),
              testing::HasSubstr("'heading_deg' is missing, expected a number"));
  EXPECT_THAT(error_of(route, "waypoints:\n  - {x_m: 1, y_m: 1, heading_deg: 3}\n"),
              testing::StartsWith("drive.yaml:2:"));
}

}  // namespace
}  // namespace cogslam
