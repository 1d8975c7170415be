#pragma once

#include <cstdint>
#include <vector>

#include "core/config.hpp"
#include "sensors/faults/fault_span.hpp"

namespace cogslam {

enum class SensorKind : std::uint8_t { kLidar, kCompass, kWheels, kCamera };

enum class StreamFaultKind : std::uint8_t {
  kDropout,  ///< samples are lost, each by chance
  kFrozen,   ///< the last sample before the span comes again and again, with new stamps
  kLate,     ///< samples carry what was true some time ago, with the stamps of now
};

/// What befalls the stream of one sensor, whatever it measures.
struct StreamFault {
  StreamFaultKind kind = StreamFaultKind::kDropout;
  SensorKind sensor = SensorKind::kLidar;
  FaultSpan span{};
  double probability = 1.0;  ///< of kDropout, per sample
  Duration latency{};        ///< of kLate
  std::uint32_t number = 0;  ///< in the list of faults: names its draws
};

/// `sensor`, `from_s`, `to_s`, and `probability` of a dropout or `latency_s` of a late one.
StreamFault read_stream_fault(ConfigSection& section, StreamFaultKind kind, std::uint32_t number);

/// Those of one sensor, in their order.
std::vector<StreamFault> faults_of(SensorKind sensor, const std::vector<StreamFault>& faults);

/// Whether sample `index` is lost to a dropout.
bool is_lost(const StreamFault& dropout, std::uint32_t seed, std::uint64_t index);

}  // namespace cogslam
