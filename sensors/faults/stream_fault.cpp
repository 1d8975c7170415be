#include "sensors/faults/stream_fault.hpp"

#include "core/rng.hpp"

namespace cogslam {

StreamFault read_stream_fault(ConfigSection& section, StreamFaultKind kind, std::uint32_t number) {
  StreamFault fault{.kind = kind, .number = number};
  if (!section.has("sensor")) {
    section.fail("sensor", "'sensor' is missing, expected one of lidar, compass, wheels, camera");
  }
  section.read_choice("sensor", fault.sensor,
                      {{"lidar", SensorKind::kLidar},
                       {"compass", SensorKind::kCompass},
                       {"wheels", SensorKind::kWheels},
                       {"camera", SensorKind::kCamera}});
  fault.span = read_fault_span(section);
  if (kind == StreamFaultKind::kDropout) section.read("probability", fault.probability, {0.0, 1.0});
  if (kind == StreamFaultKind::kLate) {
    double latency_s = 0.1;
    section.read("latency_s", latency_s, {0.0, 60.0});
    fault.latency = Duration::from_seconds(latency_s);
  }
  return fault;
}

std::vector<StreamFault> faults_of(SensorKind sensor, const std::vector<StreamFault>& faults) {
  std::vector<StreamFault> own;
  for (const StreamFault& fault : faults) {
    if (fault.sensor == sensor) own.push_back(fault);
  }
  return own;
}

bool is_lost(const StreamFault& dropout, std::uint32_t seed, std::uint64_t index) {
  Rng rng({.seed = seed, .purpose = Purpose::kSensorFault, .entity = dropout.number, .tick = index});
  return rng.uniform() < dropout.probability;
}

}  // namespace cogslam
