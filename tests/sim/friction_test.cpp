#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/rng.hpp"
#include "sim/simulation.hpp"
#include "tests/sim/rooms.hpp"
#include "tests/sim/runs.hpp"

namespace cogslam {
namespace {

TEST(Energy, NeverGrowsWithTheMotorsOff) {
  const RobotConfig config;
  for (std::uint64_t i = 0; i < 10; ++i) {
    Rng rng({.seed = 4, .purpose = Purpose::kWorld, .tick = i});
    Simulation simulation(empty_room(4.0, 4.0), config, 1);
    simulation.command(Twist2{rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), rng.uniform(-1.0, 1.0)});
    run_for(simulation, 1.0);
    simulation.coast();
    simulation.push({rng.uniform(-6.0, 6.0), rng.uniform(-6.0, 6.0)}, rng.uniform(-0.2, 0.2));
    double before = kinetic_energy(config, simulation.step());
    for (int step = 0; step < 5000; ++step) {
      const double now = kinetic_energy(config, simulation.step());
      // Single precision velocities: one part in 10^6 of the energy comes and goes.
      ASSERT_LE(now, before * (1.0 + 1e-6) + 1e-9) << "case " << i << ", step " << step;
      before = now;
    }
  }
}

TEST(Energy, IsLostToFrictionWhenTheWheelsAreHeld) {
  const RobotConfig config = even_robot();
  for (const Eigen::Vector2d& impulse : {Eigen::Vector2d(3.0, 0.0), {0.0, 3.0}, {-2.0, 2.0}}) {
    Simulation simulation(empty_room(8.0, 8.0), config, 1);
    simulation.command(WheelSpeeds{});
    simulation.push(impulse, 0.05);
    const double before = kinetic_energy(config, simulation.truth());
    run_for(simulation, 2.0);
    EXPECT_LT(kinetic_energy(config, simulation.truth()), 1e-8);
    EXPECT_EQ(before, 0.0);  // the push is felt in the next step
    EXPECT_GT(simulation.truth().T_map_base.position().norm(), 0.01);
  }
}

TEST(Friction, HoldsWheelsThatHaveGripWithoutCreep) {
  RobotConfig config = even_robot();
  config.motor.max_torque = 0.2;  // 4 N at the rim, where the floor would hold 12 N
  Simulation simulation(empty_room(20.0, 20.0), config, 1);
  simulation.command(Twist2{0.4, 0.2, 0.6});
  double worst = 0.0;
  for (int step = 0; step < 1500; ++step) {
    simulation.step();
    if (step < 10) continue;  // the solver warms up
    for (const WheelContact& wheel : simulation.wheel_contacts()) worst = std::max(worst, std::abs(wheel.slip));
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(Friction, SlidingWheelsBrakeWithTheWeightTimesFriction) {
  // A free vehicle pushed sideways so hard that every roller slides: wheels of very high inertia do not spin up, the
  // forces along the four axes add to mu m g / sqrt(2).
  RobotConfig config = even_robot();
  config.wheel_inertia = 1e3;
  Simulation simulation(empty_room(100.0, 100.0), config, 1);
  simulation.coast();
  simulation.push({0.0, 30.0});  // 5 m/s
  const double before = simulation.step().twist.y;
  for (int step = 0; step < 500; ++step) simulation.step();
  EXPECT_NEAR((before - simulation.truth().twist.y) / 0.5, config.friction * 9.81 / std::sqrt(2.0), 1e-2);
}

TEST(Friction, StaysInsideTheCone) {
  RobotConfig config;
  config.friction = 0.15;
  Simulation simulation(empty_room(3.0, 3.0), config, 2);
  int sliding = 0;
  for (int step = 0; step < 20000; ++step) {
    if (step % 700 == 0) {
      Rng rng({.seed = 8, .purpose = Purpose::kWorld, .tick = static_cast<std::uint64_t>(step)});
      simulation.command(Twist2{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-2.0, 2.0)});
    }
    simulation.step();
    for (const WheelContact& wheel : simulation.wheel_contacts()) {
      ASSERT_LE(std::abs(wheel.impulse), wheel.limit * (1.0 + 1e-12));
      const bool slides = std::abs(wheel.slip) > 0.02;
      sliding += slides ? 1 : 0;
      // Dry friction: a wheel that slides does so against the full force.
      if (slides) {
        ASSERT_LT(wheel.impulse * wheel.slip, 0.0);
      }
    }
  }
  EXPECT_GT(sliding, 1000);
}

/// Way slipped by all four rollers [m] while the vehicle sets off, on a floor of the stated grip.
double slipped_way(double patch_friction) {
  World world = empty_room(10.0, 10.0);
  world.slip_patches = {{.centre = {0.0, 0.0}, .radius = 3.0, .friction = patch_friction}};
  Simulation simulation(world, even_robot(), 1);
  simulation.command(Twist2{1.0, 0.0, 0.0});
  double way = 0.0;
  for (int step = 0; step < 2000; ++step) {
    simulation.step();
    for (const WheelContact& wheel : simulation.wheel_contacts()) way += std::abs(wheel.slip) * 1e-3;
  }
  return way;
}

TEST(Friction, SlipPatchesMakeWheelsSlip) {
  const double dry = slipped_way(1.0), wet = slipped_way(0.2), icy = slipped_way(0.05);
  EXPECT_LT(dry, 0.25);
  EXPECT_GT(wet, dry + 0.1);
  EXPECT_GT(icy, 2.0 * wet);
}

TEST(Friction, APatchUnderOneSideTurnsTheVehicle) {
  World world = empty_room(10.0, 10.0);
  world.slip_patches = {{.centre = {0.0, 1.05}, .radius = 1.0, .friction = 0.0}};  // left wheels only
  Simulation simulation(world, even_robot(), 1);
  simulation.command(Twist2{0.5, 0.0, 0.0});
  run_for(simulation, 0.3);
  EXPECT_GT(simulation.truth().T_map_base.theta, 0.02);
}

}  // namespace
}  // namespace cogslam
