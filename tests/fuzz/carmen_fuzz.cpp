#include "sensors/log/carmen_log.hpp"

#include "slam/sweep.hpp"
#include "tests/fuzz/fuzz_input.hpp"

// CARMEN logs, plain and gzipped.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cogslam;
  const MemoryFile file(text_of(data, size));
  read_or_complain([&] {
    const CarmenLog log = read_carmen_log(file.path());
    promise(!log.readings.empty() && log.readings.size() == log.odometry.size());
    for (const Reading& reading : log.readings) {
      promise(reading.motion.T_before_now.position().allFinite() && reading.motion.covariance.allFinite());
      for (const Beam& beam : sweep_of(reading, {})) promise(beam.end.allFinite());
    }
  });
  return 0;
}
