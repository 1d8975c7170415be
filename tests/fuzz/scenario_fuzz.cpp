#include "core/config.hpp"
#include "eval/replay_source.hpp"
#include "eval/scenario.hpp"
#include "tests/fuzz/fuzz_input.hpp"

// Strict YAML, as a scenario (world, robot, drive, sensors, filters) and as the configuration of a replay.

namespace cogslam {
namespace {

/// The resolved text of a file loads as itself.
template <class Read>
void read_twice(const std::string& text, Read&& read) {
  const std::string resolved = read(ConfigSection::parse(text, "a.yaml")).resolved;
  promise(read(ConfigSection::parse(resolved, "resolved.yaml")).resolved == resolved);
}

}  // namespace
}  // namespace cogslam

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cogslam;
  const std::string text(text_of(data, size));
  read_or_complain([&] { read_twice(text, [](ConfigSection file) { return read_scenario(file, "name"); }); });
  read_or_complain([&] { read_twice(text, [](ConfigSection file) { return read_replay_config(file); }); });
  return 0;
}
