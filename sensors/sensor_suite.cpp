#include "sensors/sensor_suite.hpp"

namespace cogslam {

SensorSuiteConfig read_sensor_suite_config(ConfigSection& sensors) {
  SensorSuiteConfig c;
  ConfigSection lidar = sensors.section("lidar"), compass = sensors.section("compass");
  ConfigSection reference = sensors.section("reference"), wheels = sensors.section("wheels");
  c.lidar = read_lidar_config(lidar);
  c.compass = read_compass_config(compass);
  c.reference = read_reference_config(reference);
  c.wheels = read_wheel_encoder_config(wheels);
  return c;
}

SensorSuite::SensorSuite(const SensorSuiteConfig& config, const World& world, std::uint32_t seed)
    : config_(config),
      lidar_(config.lidar, world, seed),
      compass_(config.compass, seed),
      reference_(config.reference, seed),
      lidar_times_(config.lidar.rate_hz),
      compass_times_(config.compass.rate_hz),
      reference_times_(config.reference.rate_hz),
      wheel_times_(config.wheels.rate_hz),
      camera_times_(config.camera_rate_hz),
      track_(lidar_.sweep_time()) {}

const SensorOutput& SensorSuite::step(const Truth& truth) {
  output_ = {};
  if (track_.empty())
    for (Schedule* s : {&lidar_times_, &compass_times_, &reference_times_, &wheel_times_, &camera_times_})
      s->start_at(truth.time);
  track_.push(truth);

  wheel_times_.take_until(truth.time, [&](Time t, std::uint64_t) {
    output_.wheels.push_back(encode_wheels(config_.wheels, track_.at(t)));
  });
  compass_times_.take_until(truth.time, [&](Time t, std::uint64_t n) {
    output_.compass.push_back(compass_.sample(track_.at(t).T_map_base, t, n));
  });
  camera_times_.take_until(truth.time, [&](Time t, std::uint64_t) { output_.camera_due.push_back(track_.at(t)); });
  reference_times_.take_until(truth.time, [&](Time t, std::uint64_t n) {
    output_.reference.push_back(reference_.fix(track_.at(t).T_map_base, t, n));
  });
  lidar_times_.take_until(truth.time - lidar_.sweep_time(),
                          [&](Time t, std::uint64_t n) { output_.scans.push_back(lidar_.sweep(track_, t, n)); });
  return output_;
}

}  // namespace cogslam
