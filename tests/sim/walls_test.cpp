#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/rng.hpp"
#include "sim/simulation.hpp"
#include "tests/sim/rooms.hpp"
#include "tests/sim/runs.hpp"

namespace cogslam {
namespace {

/// How far the true outline reaches beyond the walls of `empty_room(length, width)`; negative: the gap left [m].
double penetration(const RobotConfig& config, const Pose2& T_map_base, double length, double width) {
  double deepest = -1e9;
  for (const Eigen::Vector2d& corner : box({0.0, 0.0}, config.length, config.width)) {
    const Eigen::Vector2d p = T_map_base * corner;
    deepest = std::max({deepest, std::abs(p.x()) - length / 2.0, std::abs(p.y()) - width / 2.0});
  }
  return deepest;
}

TEST(Walls, StopTheVehicleAtAnySpeedWithoutPenetration) {
  RobotConfig config;
  config.motor.max_speed = 100.0;
  for (const double step : {0.001, 0.002, 0.005}) {
    config.step = Duration::from_seconds(step);
    for (const double speed : {0.3, 0.5, 1.0, 2.0}) {
      for (const double direction : {0.0, 0.6, 1.6, 3.0}) {
        Simulation simulation(empty_room(3.0, 2.4), config, 1);
        simulation.command(Twist2{speed * std::cos(direction), speed * std::sin(direction), 0.0});
        double deepest = -1.0;
        bool touched = false;
        const int steps = static_cast<int>(8.0 / step);
        for (int i = 0; i < steps; ++i) {
          const Truth& truth = simulation.step();
          deepest = std::max(deepest, penetration(config, truth.T_map_base, 3.0, 2.4));
          touched = touched || truth.in_contact;
        }
        EXPECT_TRUE(touched);
        EXPECT_LE(deepest, 0.0) << "speed " << speed << " direction " << direction << " step " << step;
        EXPECT_GE(deepest, -0.0105) << "stops too early";
      }
    }
  }
}

TEST(Walls, HoldBoxesToo) {
  World world = empty_room(6.0, 6.0);
  world.obstacles = {box({1.0, 0.0}, 0.4, 0.4)};
  const RobotConfig config = even_robot();
  Simulation simulation(world, config, 1);
  simulation.command(Twist2{0.5, 0.0, 0.0});
  run_for(simulation, 4.0);
  EXPECT_TRUE(simulation.truth().in_contact);
  EXPECT_NEAR(simulation.truth().T_map_base.x, 0.8 - config.length / 2.0, 0.01);
}

TEST(Walls, AreNotTouchedInTheOpen) {
  Simulation simulation(empty_room(3.0, 3.0), RobotConfig{}, 1);
  simulation.command(Twist2{0.2, 0.0, 0.3});
  for (int i = 0; i < 2000; ++i) ASSERT_FALSE(simulation.step().in_contact);
}

TEST(CastRay, MeetsTheNearestSurfaceAndIgnoresTheVehicle) {
  World world = empty_room(6.0, 4.0);
  world.obstacles = {box({2.0, 0.0}, 0.5, 0.5)};
  const Simulation simulation(world, RobotConfig{}, 1);
  EXPECT_NEAR(*simulation.cast_ray({0.0, 0.0}, {1.0, 0.0}, 30.0), 1.75, 1e-5);
  EXPECT_NEAR(*simulation.cast_ray({0.0, 0.0}, {-1.0, 0.0}, 30.0), 3.0, 1e-5);
  EXPECT_NEAR(*simulation.cast_ray({-2.0, 0.0}, {1.0, 0.0}, 30.0), 3.75, 1e-5);  // straight through the vehicle
  EXPECT_NEAR(*simulation.cast_ray({0.0, 0.0}, {0.6, 0.8}, 30.0), 2.5, 1e-5);
}

TEST(CastRay, FindsNothingBeyondItsRange) {
  const Simulation simulation(empty_room(6.0, 4.0), RobotConfig{}, 1);
  EXPECT_FALSE(simulation.cast_ray({0.0, 0.0}, {1.0, 0.0}, 2.9).has_value());
  EXPECT_TRUE(simulation.cast_ray({0.0, 0.0}, {1.0, 0.0}, 3.1).has_value());
}

TEST(CastRay, HitsSurfacesFromBothSides) {
  const Simulation simulation(empty_room(6.0, 4.0), RobotConfig{}, 1);
  EXPECT_NEAR(*simulation.cast_ray({-5.0, 0.0}, {1.0, 0.0}, 30.0), 2.0, 1e-5);
}

}  // namespace
}  // namespace cogslam
