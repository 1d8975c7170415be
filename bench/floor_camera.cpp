// Time of one picture of the floor, and of what spoils it.
//
// 2 cores AMD EPYC (shared), g++ 12.2 -O3: see docs/odometry.md for the figures and the conclusion.
#include <benchmark/benchmark.h>

#include "sensors/floor_camera.hpp"
#include "sensors/pixel_noise.hpp"
#include "worlds/floor_texture.hpp"

namespace cogslam {
namespace {

FloorCameraConfig camera_of(benchmark::State& state) {
  FloorCameraConfig config;
  config.model.width = static_cast<int>(state.range(0));
  config.model.height = config.model.width * 3 / 4;
  return config;
}

void capture_while_moving(benchmark::State& state, const FloorCameraConfig& config) {
  FloorCamera camera(config, Floor{}, 1);
  const Twist2 twist{0.3, 0.0, 0.5};
  Pose2 T_map_base;
  std::uint64_t frame = 0;
  for (auto _ : state) {
    T_map_base = T_map_base * Pose2::exp((1.0 / 30.0) * twist);
    benchmark::DoNotOptimize(camera.capture(frame, {static_cast<std::int64_t>(frame) * 33'333'333}, T_map_base, twist));
    ++frame;
  }
}

void rendered(benchmark::State& state) {
  FloorCameraConfig config = camera_of(state);
  config.noise = 0.0;
  capture_while_moving(state, config);
}
BENCHMARK(rendered)->Arg(320)->Arg(640)->Unit(benchmark::kMicrosecond);

void rendered_with_noise(benchmark::State& state) { capture_while_moving(state, camera_of(state)); }
BENCHMARK(rendered_with_noise)->Arg(320)->Arg(640)->Unit(benchmark::kMicrosecond);

void rendered_with_noise_and_exposure(benchmark::State& state) {
  FloorCameraConfig config = camera_of(state);
  config.exposure = 0.01;
  capture_while_moving(state, config);
}
BENCHMARK(rendered_with_noise_and_exposure)->Arg(320)->Unit(benchmark::kMicrosecond);

void noise_alone(benchmark::State& state) {
  std::vector<std::uint8_t> grey(static_cast<std::size_t>(320 * 240), 128);
  const std::vector<float> gains(grey.size(), 1.0F);
  std::uint64_t frame = 0;
  for (auto _ : state) {
    light_and_noise(grey, gains, 1.0, 3.0, {1, Purpose::kCameraNoise, 0, frame++});
    benchmark::DoNotOptimize(grey.data());
  }
}
BENCHMARK(noise_alone)->Unit(benchmark::kMicrosecond);

void painting(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(paint_floor({.kind = static_cast<FloorKind>(state.range(0))}));
}
BENCHMARK(painting)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cogslam

BENCHMARK_MAIN();
