#include <cmath>

#include "eval/lab/map_source.hpp"
#include "tests/fuzz/fuzz_input.hpp"

// Maps that people hand in: NumPy files, and numbers separated by commas.

namespace cogslam {
namespace {

void check(const Grid<float>& map) {
  promise(map.frame().width > 0 && map.frame().height > 0 && map.values().size() == map.frame().size());
  for (const float value : map.values()) promise(std::isfinite(value));
}

}  // namespace
}  // namespace cogslam

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cogslam;
  const MemoryFile file(text_of(data, size));
  read_or_complain([&] { check(read_npy(file.path())); });
  read_or_complain([&] { check(read_csv(file.path())); });
  return 0;
}
