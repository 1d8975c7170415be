#include <benchmark/benchmark.h>

#include <cmath>

#include "core/rng.hpp"
#include "sim/simulation.hpp"

namespace cogslam {
namespace {

World room(double side) {
  World world;
  const double h = side / 2.0;
  world.walls = {{{-h, -h}, {h, -h}, {h, h}, {-h, h}}};
  return world;
}

/// A 10 m room with 50 boxes of 0.2 to 0.6 m on a jittered lattice; the middle stays free for the vehicle.
World room_with_boxes() {
  World world = room(10.0);
  for (int i = 0; world.obstacles.size() < 50; ++i) {
    const Eigen::Vector2d middle(-4.2 + 1.2 * (i % 8), -4.2 + 1.2 * (i / 8));
    if (middle.norm() < 1.0) continue;
    Rng rng({.seed = 1, .purpose = Purpose::kWorld, .tick = static_cast<std::uint64_t>(i)});
    const Pose2 T_map_box{middle.x() + rng.uniform(-0.2, 0.2), middle.y() + rng.uniform(-0.2, 0.2), rng.uniform(0, 3)};
    const double a = rng.uniform(0.1, 0.3), b = rng.uniform(0.1, 0.3);
    Polygon box;
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-a, -b), {a, -b}, {a, b}, {-a, b}}) {
      box.push_back(T_map_box * corner);
    }
    world.obstacles.push_back(box);
  }
  return world;
}

/// Steps of 1 ms with a new command every 2 s, so that the vehicle wanders and, among boxes, pushes against them.
void wander(benchmark::State& state, const World& world, double speed, const RobotConfig& config = {}) {
  Simulation simulation(world, config, 1);
  std::uint64_t step = 0, contacts = 0;
  for (auto _ : state) {
    if (step % 2000 == 0) {
      Rng rng({.seed = 2, .purpose = Purpose::kWorld, .tick = step});
      const double direction = rng.uniform(-3.14, 3.14);
      simulation.command(Twist2{speed * std::cos(direction), speed * std::sin(direction), rng.uniform(-0.5, 0.5)});
    }
    contacts += simulation.step().in_contact ? 1 : 0;
    ++step;
  }
  state.counters["contact_share"] = static_cast<double>(contacts) / static_cast<double>(step);
}

/// A vehicle that pushes against a wall all the time.
void against_wall(benchmark::State& state, const World& world) {
  Simulation simulation(world, {}, 1);
  simulation.command(Twist2{0.3, 0.1, 0.0});
  for (int i = 0; i < 60000; ++i) simulation.step();
  std::uint64_t step = 0, contacts = 0;
  for (auto _ : state) {
    contacts += simulation.step().in_contact ? 1 : 0;
    ++step;
  }
  state.counters["contact_share"] = static_cast<double>(contacts) / static_cast<double>(step);
}

// One step of 1 ms costs 1.3 us in the open (0.3 us of it for drawing the roughness of the floor) and 3.0 us among 50
// boxes while the vehicle pushes against one of them most of the time: 0.1 to 0.3 % of a core at real time, so a
// longer step would gain nothing. Medians of CPU time, 5 repetitions, g++ 12.2 -O3, one of 2 cores of a virtual Intel
// Xeon at 2.6 GHz under a load of 5.
RobotConfig even_floor() {
  RobotConfig config;
  config.roughness.rolling = 0.0;
  config.roughness.grip = 0.0;
  return config;
}

void BM_StepFreeRoom(benchmark::State& state) { wander(state, room(1000.0), 0.3); }
void BM_StepFreeRoomEvenFloor(benchmark::State& state) { wander(state, room(1000.0), 0.3, even_floor()); }
void BM_StepFiftyBoxes(benchmark::State& state) { wander(state, room_with_boxes(), 0.5); }
void BM_StepFiftyBoxesContact(benchmark::State& state) { against_wall(state, room_with_boxes()); }

BENCHMARK(BM_StepFreeRoom)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_StepFreeRoomEvenFloor)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_StepFiftyBoxes)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_StepFiftyBoxesContact)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cogslam

BENCHMARK_MAIN();
