#pragma once

#include <cstdint>
#include <vector>

#include "core/config.hpp"
#include "sensors/compass.hpp"
#include "sensors/faults/faulty_stream.hpp"
#include "sensors/faults/sensor_faults.hpp"
#include "sensors/lidar.hpp"
#include "sensors/pose_track.hpp"
#include "sensors/reference.hpp"
#include "sensors/schedule.hpp"
#include "sensors/wheel_encoder.hpp"

namespace cogslam {

struct SensorSuiteConfig {
  LidarConfig lidar{};
  CompassConfig compass{};
  ReferenceConfig reference{};
  WheelEncoderConfig wheels{};
  double camera_rate_hz = 0.0;  ///< how often `camera_due` is filled; 0: never. The camera has its own reader.
  SensorFaults faults{};        ///< those of the camera's pictures are left to whoever takes them
};

/// Reads `lidar`, `compass`, `reference` and `wheels` of the section `sensors`; leaves `camera` to the camera's reader,
/// and faults to that of the list `faults`.
SensorSuiteConfig read_sensor_suite_config(ConfigSection& sensors);

/// What the sensors gave between two steps of the simulation, each list in the order of its stamps.
struct SensorOutput {
  std::vector<WheelSample> wheels;
  std::vector<CompassSample> compass;
  std::vector<Truth> camera_due;        ///< true state at each moment at which the floor camera exposes
  std::vector<ReferenceFix> reference;  ///< for the truth log only
  std::vector<ScanSample> scans;        ///< given out when the last beam is in, up to a sweep after the stamp; without
                                        ///< ranges where a sweep was due and was lost
};

/// All sensors of the vehicle but the picture of the camera, each at its own rate and with its own streams. Every
/// sensor is read at its own moment (multiples of 1 / rate from time 0), also between two steps. Faults change what a
/// sensor says, never the draws of another.
class SensorSuite {
 public:
  SensorSuite(const SensorSuiteConfig& config, const World& world, std::uint32_t seed);

  /// Takes the next true state; times rise from call to call. The answer is good until the next call.
  const SensorOutput& step(const Truth& truth);

  [[nodiscard]] const Lidar& lidar() const { return lidar_; }
  [[nodiscard]] const Compass& compass() const { return compass_; }

 private:
  [[nodiscard]] ScanSample sweep(Time stamp, std::uint64_t index);

  SensorSuiteConfig config_;
  std::uint32_t seed_;
  Lidar lidar_;
  Compass compass_;
  Reference reference_;
  Schedule lidar_times_, compass_times_, reference_times_, wheel_times_, camera_times_;
  FaultyStream<ScanSample> lidar_stream_;
  FaultyStream<CompassSample> compass_stream_;
  FaultyStream<WheelSample> wheel_stream_;
  PoseTrack track_;
  SensorOutput output_;
};

}  // namespace cogslam
