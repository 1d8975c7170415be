#include "sim/driver.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "sim/simulation.hpp"
#include "tests/sim/rooms.hpp"
#include "tests/sim/runs.hpp"

namespace cogslam {
namespace {

/// Drives until `legs` are done or time is up, and shows every state to `see(truth, legs_done)`.
template <class See>
void drive(Simulation& simulation, Driver& driver, int legs, double seconds, See&& see) {
  while (driver.legs_done() < legs && simulation.truth().time < Time::from_seconds(seconds)) {
    simulation.command(driver.command(simulation.truth()));
    see(simulation.step(), driver.legs_done());
  }
}

DriveConfig mixed_route() {
  DriveConfig config;
  config.waypoints = {{.p_map = {1.4, 0.0}},
                      {.p_map = {1.4, 1.4}, .mode = LegHeading::kKeep},
                      {.p_map = {-1.4, 1.4}, .mode = LegHeading::kTurn, .turn_rate = 0.5},
                      {.p_map = {-1.4, -1.4}, .mode = LegHeading::kFace, .heading = radians(180.0)},
                      {.p_map = {0.0, -1.4}, .mode = LegHeading::kKeep},
                      {.p_map = {0.0, 0.0}}};
  return config;
}

TEST(Driver, VisitsAllWaypointsWithinFiveCentimetresLapAfterLap) {
  const DriveConfig config = mixed_route();
  Simulation simulation(empty_room(4.0, 4.0), RobotConfig{}, 3);
  Driver driver(config);
  std::vector<double> nearest(2 * config.waypoints.size(), 1e9);
  drive(simulation, driver, 12, 200.0, [&](const Truth& truth, int leg) {
    ASSERT_FALSE(truth.in_contact);
    const auto i = static_cast<std::size_t>(leg);
    if (i >= nearest.size()) return;
    const Waypoint& goal = config.waypoints[i % config.waypoints.size()];
    nearest[i] = std::min(nearest[i], (goal.p_map - truth.T_map_base.position()).norm());
  });
  EXPECT_EQ(driver.legs_done(), 12);
  EXPECT_THAT(nearest, testing::Each(testing::Lt(0.05)));
  EXPECT_FALSE(driver.stuck());
}

TEST(Driver, KeepsFacesAndTurnsAsTheLegSays) {
  Simulation simulation(empty_room(4.0, 4.0), even_robot(), 3);
  Driver driver(mixed_route());
  double keep_error = 0.0, turned = 0.0, face_error = 1.0, before = 0.0;
  drive(simulation, driver, 4, 100.0, [&](const Truth& truth, int leg) {
    if (leg == 1) keep_error = std::max(keep_error, std::abs(truth.T_map_base.theta));
    if (leg == 2) turned += angle_difference(truth.T_map_base.theta, before);
    if (leg == 3) face_error = std::abs(angle_difference(truth.T_map_base.theta, radians(180.0)));
    before = truth.T_map_base.theta;
  });
  EXPECT_LT(keep_error, radians(3.0));
  EXPECT_NEAR(turned, 0.5 * 2.8 / 0.3, 0.5);  // the leg takes a little over 2.8 m / 0.3 m/s
  EXPECT_LE(face_error, radians(2.1));
}

TEST(Driver, TurnsOnTheSpotBeforeItLeavesAWaypointThatStatesAHeading) {
  DriveConfig config;
  config.waypoints = {{.p_map = {0.0, 0.0}, .mode = LegHeading::kFace, .heading = radians(90.0)},
                      {.p_map = {1.0, 0.0}, .mode = LegHeading::kKeep}};
  Simulation simulation(empty_room(4.0, 4.0), even_robot(), 3);
  Driver driver(config);
  drive(simulation, driver, 1, 60.0, [](const Truth&, int) {});
  EXPECT_NEAR(simulation.truth().T_map_base.theta, radians(90.0), radians(2.1));
  EXPECT_LT(simulation.truth().T_map_base.position().norm(), 0.02);
  drive(simulation, driver, 2, 60.0, [](const Truth&, int) {});
  EXPECT_NEAR(simulation.truth().T_map_base.theta, radians(90.0), radians(2.1));
}

TEST(Driver, LooksAlongTheLegBeforeItDrivesOff) {
  DriveConfig config;
  config.waypoints = {{.p_map = {-1.4, 0.0}}};
  Simulation simulation(empty_room(4.0, 4.0), even_robot(), 3);
  Driver driver(config);
  drive(simulation, driver, 1, 60.0, [](const Truth& truth, int) {
    const double off = std::abs(angle_difference(truth.T_map_base.theta, radians(180.0)));
    if (off > radians(100.0)) {
      ASSERT_LT(std::hypot(truth.twist.x, truth.twist.y), 0.02);
    }
  });
  EXPECT_EQ(driver.legs_done(), 1);
}

TEST(Driver, StaysWithinSpeedAndAcceleration) {
  const DriveConfig config = mixed_route();
  Simulation simulation(empty_room(4.0, 4.0), RobotConfig{}, 3);
  Driver driver(config);
  Eigen::Vector2d before(0.0, 0.0);
  double omega_before = 0.0;
  for (int step = 0; step < 60000; ++step) {
    const Truth& truth = simulation.truth();
    const Twist2 twist = driver.command(truth);
    const Eigen::Vector2d v = Pose2{0.0, 0.0, truth.T_map_base.theta} * Eigen::Vector2d(twist.x, twist.y);
    ASSERT_LE(v.norm(), config.speed + 1e-9);
    ASSERT_LE(std::abs(twist.theta), config.yaw_rate + 1e-9);
    ASSERT_LE((v - before).norm(), config.acceleration * 1e-3 + 1e-9);
    ASSERT_LE(std::abs(twist.theta - omega_before), config.yaw_acceleration * 1e-3 + 1e-9);
    before = v;
    omega_before = twist.theta;
    simulation.command(twist);
    simulation.step();
  }
}

TEST(Driver, ReachesItsSpeedOnALongLeg) {
  DriveConfig config;
  config.waypoints = {{.p_map = {8.0, 0.0}}};
  Simulation simulation(empty_room(20.0, 4.0), even_robot(), 3);
  Driver driver(config);
  double fastest = 0.0;
  drive(simulation, driver, 1, 60.0, [&](const Truth& truth, int) { fastest = std::max(fastest, truth.twist.x); });
  EXPECT_NEAR(fastest, 0.3, 0.02);
  EXPECT_LT(simulation.truth().time, Time::from_seconds(8.0 / 0.3 + 2.5));
}

TEST(Driver, SaysWhenItIsStuck) {
  World world = empty_room(4.0, 4.0);
  world.obstacles = {box({1.0, 0.0}, 0.3, 3.9)};
  DriveConfig config;
  config.waypoints = {{.p_map = {1.6, 0.0}, .mode = LegHeading::kKeep}};
  Simulation simulation(world, even_robot(), 3);
  Driver driver(config);
  double stuck_at = -1.0;
  drive(simulation, driver, 1, 30.0, [&](const Truth& truth, int) {
    if (stuck_at < 0.0 && driver.stuck()) stuck_at = truth.time.seconds();
  });
  EXPECT_EQ(driver.legs_done(), 0);
  EXPECT_TRUE(driver.stuck());
  EXPECT_GT(stuck_at, 2.0 + 5.0);  // 0.64 m to the box
  EXPECT_LT(stuck_at, 2.5 + 10.0);
}

TEST(Driver, StandsStillWithoutARoute) {
  Simulation simulation(empty_room(4.0, 4.0), RobotConfig{}, 3);
  Driver driver(DriveConfig{});
  for (int step = 0; step < 12000; ++step) {
    simulation.command(driver.command(simulation.truth()));
    simulation.step();
  }
  EXPECT_LT(simulation.truth().T_map_base.position().norm(), 1e-6);
  EXPECT_FALSE(driver.stuck());
}

TEST(Driver, PlaysAScriptAndRepeatsIt) {
  DriveConfig config;
  config.kind = DriveKind::kScript;
  config.script = {{Duration::from_seconds(1.0), {0.2, 0.0, 0.0}}, {Duration::from_seconds(0.5), {0.0, -0.1, 0.3}}};
  Driver driver(config);
  const auto at = [&](double seconds) { return driver.command({.time = Time::from_seconds(seconds)}); };
  EXPECT_EQ(at(0.0), (Twist2{0.2, 0.0, 0.0}));
  EXPECT_EQ(at(0.999), (Twist2{0.2, 0.0, 0.0}));
  EXPECT_EQ(at(1.0), (Twist2{0.0, -0.1, 0.3}));
  EXPECT_EQ(at(1.5), (Twist2{0.2, 0.0, 0.0}));
  EXPECT_EQ(at(4.2), (Twist2{0.0, -0.1, 0.3}));
  EXPECT_EQ(driver.legs_done(), 5);
}

TEST(Driver, RefusesAScriptThatTakesNoTime) {
  DriveConfig config;
  config.script = {{Duration{0}, {0.2, 0.0, 0.0}}};
  EXPECT_THROW(Driver{config}, ContractViolation);
}

}  // namespace
}  // namespace cogslam
