#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

TEST(Walls, AreNotTouchedFromFiveCentimetres) {
  World world = empty_room(3.0, 3.0);
  world.start = {0.0, -1.5 + RobotConfig{}.width / 2.0 + 0.05, 0.0};
  Simulation simulation(world, even_robot(), 1);
  simulation.command(Twist2{0.2, 0.0, 0.0});
  for (int i = 0; i < 2000; ++i) ASSERT_FALSE(simulation.step().in_contact);
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

/// Distance to the nearest of all segments by Cramer's rule; infinity where none is hit.
double nearest_by_hand(const World& world, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction) {
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& segment : world.segments()) {
    const Eigen::Vector2d along = segment.b - segment.a, to_a = segment.a - origin;
    const double t = cross(to_a, along) / cross(direction, along), u = cross(to_a, direction) / cross(direction, along);
    if (t >= 0.0 && u >= 0.0 && u <= 1.0) nearest = std::min(nearest, t);
  }
  return nearest;
}

TEST(CastRay, AgreesWithAllSegmentsTriedByHand) {
  World world = empty_room(8.0, 8.0);
  Rng rng({.seed = 12, .purpose = Purpose::kWorld});
  for (int i = 0; i < 30; ++i) {
    world.obstacles.push_back(box({rng.uniform(-3.5, 3.5), rng.uniform(-3.5, 3.5)}, rng.uniform(0.1, 0.5),
                                  rng.uniform(0.1, 0.5), rng.uniform(0.0, 3.0)));
  }
  const Simulation simulation(world, RobotConfig{}, 1);
  int other_surface = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector2d origin(rng.uniform(-3.9, 3.9), rng.uniform(-3.9, 3.9));
    const double angle = rng.uniform(-3.14, 3.14);
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const std::optional<double> range = simulation.cast_ray(origin, direction, 30.0);
    ASSERT_TRUE(range.has_value());
    // Grazing a corner, single precision may take the surface behind it.
    if (std::abs(*range - nearest_by_hand(world, origin, direction)) > 1e-3) ++other_surface;
  }
  EXPECT_LE(other_surface, 2);
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
