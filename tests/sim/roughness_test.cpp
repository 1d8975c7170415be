#include <gtest/gtest.h>

#include <cmath>

#include "sim/simulation.hpp"
#include "sim/wheel_roughness.hpp"
#include "tests/sim/rooms.hpp"
#include "tests/sim/runs.hpp"

namespace cogslam {
namespace {

TEST(WheelRoughness, HasTheStatedMeanSpreadAndLength) {
  const RoughnessConfig config{.rolling = 0.03, .grip = 0.0, .length = 0.05};
  WheelRoughness roughness(config, 7);
  constexpr double kWay = 0.01;
  constexpr int kSteps = 200000, kLag = 5;  // a lag of one length
  std::vector<double> values;
  for (int step = 1; step <= kSteps; ++step) {
    roughness.roll({kWay, kWay, kWay, kWay}, static_cast<std::uint64_t>(step));
    values.push_back(roughness.radius_factor(2) - 1.0);
  }
  double sum = 0.0, squares = 0.0, lagged = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    squares += values[i] * values[i];
    if (i >= kLag) lagged += values[i] * values[i - kLag];
  }
  // About kSteps / 10 independent values: standard errors 0.0002, 0.7 % and 0.7 %.
  EXPECT_NEAR(sum / kSteps, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / kSteps), config.rolling, 0.03 * config.rolling);
  EXPECT_NEAR(lagged / squares, std::exp(-1.0), 0.03);
}

TEST(WheelRoughness, StaysWhereItIsWhileTheWheelStands) {
  WheelRoughness roughness({.rolling = 0.03, .grip = 0.1, .length = 0.05}, 7);
  const double radius = roughness.radius_factor(0), grip = roughness.grip_factor(0);
  for (std::uint64_t step = 1; step < 100; ++step) roughness.roll({0.0, 1.0, 1.0, 1.0}, step);
  EXPECT_DOUBLE_EQ(roughness.radius_factor(0), radius);
  EXPECT_DOUBLE_EQ(roughness.grip_factor(0), grip);
  EXPECT_NE(radius, 1.0);
}

TEST(WheelRoughness, ChangesThePathButNotItsMean) {
  constexpr int kSeeds = 40;
  Pose2 even_end;
  {
    Simulation simulation(empty_room(20.0, 20.0), even_robot(), 1);
    simulation.command(Twist2{0.5, 0.0, 0.0});
    run_for(simulation, 4.0);
    even_end = simulation.truth().T_map_base;
  }
  double sum_x = 0.0, sum_y = 0.0, sum_theta = 0.0, squares_y = 0.0, squares_theta = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    RobotConfig config;
    config.step = Duration::from_seconds(0.004);
    Simulation simulation(empty_room(20.0, 20.0), config, seed);
    simulation.command(Twist2{0.5, 0.0, 0.0});
    run_for(simulation, 4.0);
    const Pose2& end = simulation.truth().T_map_base;
    sum_x += end.x;
    sum_y += end.y;
    sum_theta += end.theta;
    squares_y += end.y * end.y;
    squares_theta += end.theta * end.theta;
  }
  const double spread_y = std::sqrt(squares_y / kSeeds), spread_theta = std::sqrt(squares_theta / kSeeds);
  EXPECT_GT(spread_y, 0.003);
  EXPECT_GT(spread_theta, 0.003);
  EXPECT_NEAR(sum_x / kSeeds, even_end.x, 0.01);
  EXPECT_NEAR(sum_y / kSeeds, 0.0, 3.0 * spread_y / std::sqrt(kSeeds));
  EXPECT_NEAR(sum_theta / kSeeds, 0.0, 3.0 * spread_theta / std::sqrt(kSeeds));
}

std::uint64_t path_hash(std::uint32_t seed) {
  World world = empty_room(3.0, 3.0);
  world.obstacles = {box({0.9, 0.3}, 0.4, 0.6, 0.3)};
  Simulation simulation(world, RobotConfig{}, seed);
  Hash hash;
  for (int step = 0; step < 8000; ++step) {
    if (step == 0) simulation.command(Twist2{0.4, 0.1, 0.2});
    if (step == 4000) simulation.command(Twist2{-0.3, 0.4, -0.5});
    add_state(hash, simulation.step());
  }
  return hash.value();
}

TEST(Determinism, TheSameSeedGivesTheSamePathToTheLastBit) {
  const std::uint64_t first = path_hash(5);
  EXPECT_EQ(path_hash(5), first);
  EXPECT_EQ(path_hash(5), first);
}

TEST(Determinism, AnotherSeedGivesAnotherPath) { EXPECT_NE(path_hash(5), path_hash(6)); }

}  // namespace
}  // namespace cogslam
