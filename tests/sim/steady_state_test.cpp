#include <gtest/gtest.h>

#include "core/rng.hpp"
#include "sim/simulation.hpp"
#include "tests/sim/rooms.hpp"
#include "tests/sim/runs.hpp"

namespace cogslam {
namespace {

Rng draws(std::uint64_t tick) { return Rng({.seed = 21, .purpose = Purpose::kWorld, .tick = tick}); }

Twist2 random_twist(Rng& rng) { return {rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), rng.uniform(-0.6, 0.6)}; }

TEST(SteadyState, IsTheTwistOfTheInverseKinematics) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    Rng rng = draws(i);
    const Twist2 wanted = random_twist(rng);
    Simulation simulation(empty_room(20.0, 20.0), even_robot(), 1);
    simulation.command(wanted);
    run_for(simulation, 3.0);
    const Truth& truth = simulation.truth();
    EXPECT_NEAR(truth.twist.x, wanted.x, 1e-3) << "case " << i;
    EXPECT_NEAR(truth.twist.y, wanted.y, 1e-3) << "case " << i;
    EXPECT_NEAR(truth.twist.theta, wanted.theta, 1e-3) << "case " << i;
    const WheelSpeeds speeds = wheel_speeds(even_robot().geometry, wanted);
    for (std::size_t wheel = 0; wheel < 4; ++wheel) EXPECT_NEAR(truth.wheel_speeds[wheel], speeds[wheel], 2e-2);
  }
}

TEST(SteadyState, StraightLinesAreExactToFiveDigits) {
  for (const Twist2& wanted : {Twist2{0.3, 0.0, 0.0}, Twist2{0.0, -0.3, 0.0}, Twist2{0.0, 0.0, 0.5}}) {
    Simulation simulation(empty_room(20.0, 20.0), even_robot(), 1);
    simulation.command(wanted);
    run_for(simulation, 3.0);
    EXPECT_NEAR(simulation.truth().twist.x, wanted.x, 1e-5);
    EXPECT_NEAR(simulation.truth().twist.y, wanted.y, 1e-5);
    EXPECT_NEAR(simulation.truth().twist.theta, wanted.theta, 1e-5);
  }
}

TEST(SteadyState, DoesNotDependOnTheStep) {
  Pose2 ends[2];
  int run = 0;
  for (const double step : {0.0005, 0.005}) {
    RobotConfig config = even_robot();
    config.step = Duration::from_seconds(step);
    Simulation simulation(empty_room(20.0, 20.0), config, 1);
    simulation.command(Twist2{0.3, 0.1, 0.4});
    run_for(simulation, 5.0);
    simulation.command(Twist2{-0.2, 0.3, -0.3});
    run_for(simulation, 5.0);
    ends[run++] = simulation.truth().T_map_base;
  }
  EXPECT_NEAR(ends[0].x, ends[1].x, 0.005);
  EXPECT_NEAR(ends[0].y, ends[1].y, 0.005);
  EXPECT_NEAR(ends[0].theta, ends[1].theta, 0.005);
}

TEST(SteadyState, TwistsBeyondTheMotorsAreScaledDownAsAWhole) {
  RobotConfig config = even_robot();
  config.motor.max_speed = 10.0;
  Simulation simulation(empty_room(40.0, 40.0), config, 1);
  simulation.command(Twist2{1.0, 0.5, 0.0});  // asks 30 rad/s of two wheels
  run_for(simulation, 3.0);
  EXPECT_NEAR(simulation.truth().twist.x, 1.0 / 3.0, 1e-3);
  EXPECT_NEAR(simulation.truth().twist.y, 0.5 / 3.0, 1e-3);
}

TEST(SteadyState, PoseIsTheIntegralOfTheTwist) {
  Simulation simulation(empty_room(20.0, 20.0), RobotConfig{}, 3);
  simulation.command(Twist2{0.3, 0.1, 0.4});
  Pose2 summed;
  for (int i = 0; i < 20000; ++i) {
    const Truth& truth = simulation.step();
    summed = summed * Pose2::exp(1e-3 * truth.twist);
  }
  EXPECT_NEAR(summed.x, simulation.truth().T_map_base.x, 2e-3);
  EXPECT_NEAR(summed.y, simulation.truth().T_map_base.y, 2e-3);
  EXPECT_NEAR(summed.theta, simulation.truth().T_map_base.theta, 2e-3);
}

TEST(Symmetry, MirroredCommandsGiveTheMirroredPath) {
  for (std::uint64_t i = 0; i < 5; ++i) {
    Simulation left(empty_room(20.0, 20.0), even_robot(), 1), right(empty_room(20.0, 20.0), even_robot(), 1);
    for (std::uint64_t part = 0; part < 4; ++part) {
      Rng rng = draws(1000 + 10 * i + part);
      const Twist2 twist = random_twist(rng);
      left.command(twist);
      right.command(Twist2{twist.x, -twist.y, -twist.theta});
      run_for(left, 1.5);
      run_for(right, 1.5);
    }
    EXPECT_NEAR(left.truth().T_map_base.x, right.truth().T_map_base.x, 2e-4);
    EXPECT_NEAR(left.truth().T_map_base.y, -right.truth().T_map_base.y, 2e-4);
    EXPECT_NEAR(left.truth().T_map_base.theta, -right.truth().T_map_base.theta, 2e-4);
  }
}

TEST(Symmetry, ARotatedWorldGivesTheRotatedPath) {
  for (std::uint64_t i = 0; i < 5; ++i) {
    Rng rng = draws(2000 + i);
    const Pose2 T_map_turned{rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0), rng.uniform(-3.0, 3.0)};
    const World upright = empty_room(4.0, 4.0);
    World turned = upright;
    for (Polygon& wall : turned.walls) {
      for (Eigen::Vector2d& corner : wall) corner = T_map_turned * corner;
    }
    turned.start = T_map_turned;
    Simulation a(upright, RobotConfig{}, 9), b(turned, RobotConfig{}, 9);
    for (int part = 0; part < 4; ++part) {
      const Twist2 twist = random_twist(rng);
      a.command(twist);
      b.command(twist);
      run_for(a, 1.5);
      run_for(b, 1.5);
    }
    const Pose2 difference = a.truth().T_map_base.inverse() * (T_map_turned.inverse() * b.truth().T_map_base);
    EXPECT_NEAR(difference.x, 0.0, 1e-3);
    EXPECT_NEAR(difference.y, 0.0, 1e-3);
    EXPECT_NEAR(difference.theta, 0.0, 1e-3);
  }
}

}  // namespace
}  // namespace cogslam
