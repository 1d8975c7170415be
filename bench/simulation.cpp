// How fast the whole simulation runs on one core, and where its time goes.
//
//   bench_simulation [simulated seconds, default 60] [repetitions, default 3]
//
// The drive is that of `record_drive`: 1 kHz physics, 40 Hz x 1081 beams with a pose for each beam, 50 Hz compass,
// wheels and wheel odometry, 10 Hz reference, 30 Hz camera of 320 x 240 with noise and without exposure blur, visual
// odometry. The vehicle circles at 0.3 m/s and 0.5 rad/s in a room of 10 x 10 m, free or among 50 boxes. Each row adds
// a part to the row above; its time is the difference. CPU time of the process, least of the repetitions.
//
//                                          free room          50 boxes
//   physics and driver                     1.4 us/step        1.4 us/step
//   compass, wheels, reference, readings   2.8 us/sample      3.2 us/sample
//   lidar                                  98 us/sweep        131 us/sweep
//   camera: set-up, render, noise          1.54 ms/picture    1.54 ms/picture
//   visual odometry                        0.90 ms/picture    0.92 ms/picture
//   real time, without visual odometry     19.4 x             18.9 x
//   real time, with it                     12.7 x             12.5 x
//
// (2 virtual cores of an Intel Xeon, g++ 12.2 -O3, load 3 to 4.5.) Conclusion: pictures are nine tenths of the time;
// physics at 1 kHz and the lidar together are 7 to 8 %, so neither a longer step nor fewer beams would make a run
// shorter.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "eval/metrics/timing.hpp"
#include "eval/recorder.hpp"
#include "sim/driver.hpp"
#include "sim/simulation.hpp"
#include "tests/support/test_worlds.hpp"

namespace cogslam {
namespace {

Scenario circling(int boxes, double seconds) {
  Scenario scenario{.name = "circling", .duration = Duration::from_seconds(seconds)};
  scenario.world = room_with_boxes(boxes, 1);
  scenario.world.start = {0.0, -0.6, 0.0};
  scenario.drive.kind = DriveKind::kScript;
  scenario.drive.script = {{scenario.duration, {0.3, 0.0, 0.5}}};
  scenario.sensors.camera_rate_hz = scenario.camera.rate;
  return scenario;
}

/// What a user gets, short of visual odometry.
Scenario without_visual_odometry(Scenario scenario) {
  scenario.odometry.source = OdometrySource::kWheel;
  return scenario;
}

Scenario without_camera(Scenario scenario) {
  scenario = without_visual_odometry(std::move(scenario));
  scenario.camera.enabled = false;
  scenario.sensors.camera_rate_hz = 0.0;
  return scenario;
}

/// Two beams instead of 1081: what remains are the other sensors and the making of readings.
Scenario without_lidar(Scenario scenario) {
  scenario = without_camera(std::move(scenario));
  scenario.sensors.lidar.beams = 2;
  return scenario;
}

void drive_only(const Scenario& scenario) {
  Simulation simulation(scenario.world, scenario.robot, scenario.seed);
  Driver driver(scenario.drive);
  const std::int64_t steps = scenario.duration.ns / scenario.robot.step.ns;
  for (std::int64_t i = 0; i < steps; ++i) {
    simulation.command(driver.command(simulation.truth()));
    simulation.step();
  }
}

template <class Work>
double least_cpu_seconds(int repetitions, const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch cpu(Clock::kProcessCpu);
    work();
    least = std::min(least, cpu.seconds());
  }
  return least;
}

struct Row {
  std::string part;
  double cpu_s;  ///< of all parts up to this one
  double per_s;  ///< how often a second
  std::string unit;
};

std::vector<Row> measure(const Scenario& whole, int repetitions) {
  const auto record = [&](const Scenario& scenario) {
    return least_cpu_seconds(repetitions, [&] { record_drive(scenario); });
  };
  std::vector<Row> rows;
  rows.push_back({"physics and driver", least_cpu_seconds(repetitions, [&] { drive_only(whole); }), 1000.0, "step"});
  rows.push_back({"compass, wheels, reference, readings", record(without_lidar(whole)), 50.0, "sample"});
  rows.push_back({"lidar", record(without_camera(whole)), whole.sensors.lidar.rate_hz, "sweep"});
  rows.push_back(
      {"camera: set-up, render, noise", record(without_visual_odometry(whole)), whole.camera.rate, "picture"});
  rows.push_back({"visual odometry", record(whole), whole.camera.rate, "picture"});
  return rows;
}

void print(const std::string& room, const std::vector<Row>& rows, double seconds) {
  fmt::print("{}\n  {:<38}{:>12}{:>16}{:>9}{:>13}\n", room, "part", "CPU s", "us each", "share", "real time x");
  double before = 0.0;
  for (const Row& row : rows) {
    const double own = row.cpu_s - before;
    fmt::print("  {:<38}{:>12.3f}{:>8.1f} {:<7}{:>7.1f} %{:>13.1f}\n", row.part, own, 1e6 * own / (seconds * row.per_s),
               "/" + row.unit, 100.0 * own / rows.back().cpu_s, seconds / row.cpu_s);
    before = row.cpu_s;
  }
  fmt::print("  without visual odometry {:.1f} x real time, with it {:.1f} x\n\n",
             seconds / rows[rows.size() - 2].cpu_s, seconds / rows.back().cpu_s);
}

}  // namespace
}  // namespace cogslam

int main(int argc, char** argv) {
  using namespace cogslam;
  const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 60.0;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 3;
  if (seconds < 1.0 || repetitions < 1) {
    fmt::print(stderr, "usage: bench_simulation [simulated seconds, at least 1] [repetitions]\n");
    return 2;
  }
  record_drive(circling(0, 0.1));  // loads what is loaded once in a program
  for (const int boxes : {0, 50}) {
    const std::string room = boxes == 0 ? "free room" : fmt::format("among {} boxes", boxes);
    print(room, measure(circling(boxes, seconds), repetitions), seconds);
  }
  return 0;
}
