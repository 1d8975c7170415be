#include "sensors/log/recording.hpp"

#include "core/hash.hpp"
#include "sensors/log/bytes.hpp"
#include "sensors/log/truth_log.hpp"
#include "slam/sweep.hpp"
#include "tests/fuzz/fuzz_input.hpp"
#include "worlds/truth_grid.hpp"

// Our binary files: recordings of readings, and their truth. The first byte says which, and whether the rest is the
// whole file or only its records; then it gets the head and the hash that let it past the door.

namespace cogslam {
namespace {

constexpr std::uint8_t kTruth = 1, kWhole = 2;

std::string with_head_and_hash(std::string_view magic, std::string_view records) {
  ByteWriter out;
  out.put_raw(magic);
  out.put(std::uint32_t{1});
  out.put_raw(records);
  Hash hash;
  hash.add(std::span<const char>(out.bytes()));
  out.put(std::uint8_t{0});
  out.put(std::uint64_t{8});
  out.put(hash.value());
  return out.bytes();
}

void read_as_recording(const MemoryFile& file) {
  const Recording recording = read_recording(file.path());
  promise(recording.start.position().allFinite());
  for (const Reading& reading : recording.readings) {
    promise(reading.motion.T_before_now.position().allFinite() && reading.motion.covariance.allFinite());
    for (const Beam& beam : sweep_of(reading, {.carve_no_return = true})) promise(beam.end.allFinite());
  }
}

void read_as_truth(const MemoryFile& file) {
  const TruthLog truth = read_truth_log(file.path());
  for (const TruePose& pose : truth.poses) promise(pose.T_map_base.position().allFinite());
  promise(truth_grid(truth.world, 10.0).frame().size() > 0);
}

}  // namespace
}  // namespace cogslam

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cogslam;
  if (size == 0) return 0;
  const bool is_truth = (data[0] & kTruth) != 0;
  std::string content(text_of(data + 1, size - 1));
  if ((data[0] & kWhole) == 0) content = with_head_and_hash(is_truth ? "COGSTRUE" : "COGSREAD", content);
  const MemoryFile file(content);
  read_or_complain([&] { is_truth ? read_as_truth(file) : read_as_recording(file); });
  return 0;
}
