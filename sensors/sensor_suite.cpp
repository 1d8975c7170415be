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
      seed_(seed),
      lidar_(config.lidar, world, seed),
      compass_(config.compass, seed, world.magnets),
      reference_(config.reference, seed),
      lidar_times_(config.lidar.rate_hz),
      compass_times_(config.compass.rate_hz),
      reference_times_(config.reference.rate_hz),
      wheel_times_(config.wheels.rate_hz),
      camera_times_(config.camera_rate_hz),
      lidar_stream_(faults_of(SensorKind::kLidar, config.faults.streams), seed),
      compass_stream_(faults_of(SensorKind::kCompass, config.faults.streams), seed),
      wheel_stream_(faults_of(SensorKind::kWheels, config.faults.streams), seed),
      track_(lidar_.sweep_time()) {}

const SensorOutput& SensorSuite::step(const Truth& truth) {
  output_ = {};
  if (track_.empty())
    for (Schedule* s : {&lidar_times_, &compass_times_, &reference_times_, &wheel_times_, &camera_times_})
      s->start_at(truth.time);
  track_.push(truth);

  wheel_times_.take_until(truth.time, [&](Time t, std::uint64_t n) {
    if (auto s = wheel_stream_.pass(encode_wheels(config_.wheels, track_.at(t)), n)) output_.wheels.push_back(*s);
  });
  compass_times_.take_until(truth.time, [&](Time t, std::uint64_t n) {
    if (auto s = compass_stream_.pass(compass_.sample(track_.at(t).T_map_base, t, n), n)) output_.compass.push_back(*s);
  });
  camera_times_.take_until(truth.time, [&](Time t, std::uint64_t) { output_.camera_due.push_back(track_.at(t)); });
  reference_times_.take_until(truth.time, [&](Time t, std::uint64_t n) {
    output_.reference.push_back(reference_.fix(track_.at(t).T_map_base, t, n));
  });
  lidar_times_.take_until(truth.time - lidar_.sweep_time(),
                          [&](Time t, std::uint64_t n) { output_.scans.push_back(sweep(t, n)); });
  return output_;
}

ScanSample SensorSuite::sweep(Time stamp, std::uint64_t index) {
  ScanSample sample = lidar_.sweep(track_, stamp, index);
  for (const OutlierBeams& fault : config_.faults.outliers) {
    if (fault.span.holds(stamp)) add_outliers(fault, seed_, index, sample.scan);
  }
  return lidar_stream_.pass(std::move(sample), index).value_or(ScanSample{.stamp = stamp, .scan = {}});
}

}  // namespace cogslam
