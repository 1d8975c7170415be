#include "sim/disturbance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/rooms.hpp"
#include "tests/sim/runs.hpp"
#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

/// How far the wheels say that the base went along x [m].
double way_of_wheels(const RobotConfig& config, const Truth& truth) {
  double sum = 0.0;
  for (const double angle : truth.wheel_angles) sum += angle;
  return config.geometry.wheel_radius * sum / 4.0;
}

void run_with(Disturbances& disturbances, Simulation& simulation, double seconds) {
  const Time end = simulation.truth().time + Duration::from_seconds(seconds);
  while (simulation.truth().time < end) {
    disturbances.apply(simulation);
    simulation.step();
  }
}

TEST(Kidnapping, MovesTheVehicleAndNotItsWheels) {
  const RobotConfig config = even_robot();
  Simulation kidnapped(empty_room(20.0, 20.0), config, 1), left_alone(empty_room(20.0, 20.0), config, 1);
  Disturbances disturbances({.pushes = {}, .kidnappings = {{Time::from_seconds(1.0), {5.0, -3.0, 2.0}}}});
  run_with(disturbances, kidnapped, 2.0);
  run_for(left_alone, 2.0);
  EXPECT_NEAR(kidnapped.truth().T_map_base.x, 5.0, 1e-4);
  EXPECT_NEAR(kidnapped.truth().T_map_base.y, -3.0, 1e-4);
  EXPECT_NEAR(kidnapped.truth().T_map_base.theta, 2.0, 1e-4);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(kidnapped.truth().wheel_angles[i], left_alone.truth().wheel_angles[i], 1e-6);
  }
}

TEST(Kidnapping, HappensOnceAtItsMoment) {
  Simulation simulation(empty_room(20.0, 20.0), even_robot(), 1);
  Disturbances disturbances({.pushes = {}, .kidnappings = {{Time::from_seconds(0.5), {5.0, 0.0, 0.0}}}});
  run_with(disturbances, simulation, 0.5);
  EXPECT_NEAR(simulation.truth().T_map_base.x, 0.0, 1e-6);
  run_with(disturbances, simulation, 0.01);
  EXPECT_NEAR(simulation.truth().T_map_base.x, 5.0, 1e-3);
  simulation.put({1.0, 0.0, 0.0});
  run_with(disturbances, simulation, 0.5);
  EXPECT_NEAR(simulation.truth().T_map_base.x, 1.0, 1e-3);
}

TEST(Push, ShovesTheVehicleFartherThanItsWheelsTell) {
  const RobotConfig config = even_robot();
  Simulation simulation(empty_room(20.0, 20.0), config, 1);
  simulation.command(Twist2{});
  Disturbances disturbances({.pushes = {{Time::from_seconds(0.2), {18.0, 0.0}, 0.0}}, .kidnappings = {}});
  run_with(disturbances, simulation, 2.0);
  const double way = simulation.truth().T_map_base.x;
  EXPECT_GT(way, 0.3);
  EXPECT_LT(std::abs(way_of_wheels(config, simulation.truth())), 0.5 * way);
}

TEST(Push, IsStoppedByAWallOfGlass) {
  World world = empty_room(20.0, 20.0);
  world.panes = {{{1.0, -2.0}, {1.0, 2.0}}};
  const RobotConfig config = even_robot();
  Simulation simulation(world, config, 1);
  Disturbances disturbances({.pushes = {{Time{}, {60.0, 0.0}, 0.0}}, .kidnappings = {}});
  double farthest = 0.0;
  bool touched = false;
  for (int i = 0; i < 2000; ++i) {
    disturbances.apply(simulation);
    const Truth& truth = simulation.step();
    farthest = std::max(farthest, truth.T_map_base.x + config.length / 2.0);
    touched = touched || truth.in_contact;
  }
  EXPECT_TRUE(touched);
  EXPECT_LE(farthest, 1.0 + 1e-9);
}

TEST(SlipPatch, LetsTheWheelsTurnFartherThanTheVehicleGets) {
  const RobotConfig config = even_robot();
  World icy = empty_room(20.0, 4.0);
  icy.slip_patches = {{{0.0, 0.0}, 1.5, 0.02}};
  Simulation on_ice(icy, config, 1), on_floor(empty_room(20.0, 4.0), config, 1);
  for (Simulation* simulation : {&on_ice, &on_floor}) {
    simulation->command(Twist2{0.5, 0.0, 0.0});
    run_for(*simulation, 1.5);
  }
  EXPECT_NEAR(way_of_wheels(config, on_floor.truth()), on_floor.truth().T_map_base.x, 0.02);
  EXPECT_GT(way_of_wheels(config, on_ice.truth()), on_ice.truth().T_map_base.x + 0.2);
}

std::string push_error(const std::string& text) {
  return error_text([&] {
    ConfigSection section = ConfigSection::parse(text, "f.yaml");
    read_push(section);
    section.finish();
  });
}

TEST(Disturbances, SayWhatIsWrongInTheFile) {
  EXPECT_EQ(push_error("{impulse_n_s: [1, 0]}"), "f.yaml:1:1: 'at_s' is missing, expected a number");
  EXPECT_EQ(push_error("{at_s: 1}"),
            "f.yaml:1:1: a push without impulse, expected impulse_n_s or angular_impulse_n_m_s other than 0");
  ConfigSection section = ConfigSection::parse("{at_s: 1, x_m: 2}", "f.yaml");
  EXPECT_EQ(error_text([&] { read_kidnapping(section); }), "f.yaml:1:1: 'y_m' is missing, expected a number");
}

}  // namespace
}  // namespace cogslam
