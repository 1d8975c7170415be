#include "tests/fuzz/fuzz_input.hpp"
#include "worlds/map_contours.hpp"
#include "worlds/map_file.hpp"

// Pictures of floors, PGM and PNG, plain and gzipped, and the surfaces drawn from small ones.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cogslam;
  constexpr std::size_t kSmall = 10'000;  // cells; drawing larger ones would take the time for new inputs
  const MemoryFile file(text_of(data, size));
  read_or_complain([&] {
    const OccupancyMap map = read_map_picture(file.path(), 0.1);
    promise(map.width > 0 && map.height > 0);
    promise(map.cells.size() == static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    if (map.cells.size() > kSmall) return;
    for (const Segment& surface : map_contours(map).segments()) {
      promise(surface.a.allFinite() && map.at(map.cell_of(surface.a)) == MapCell::kOccupied);
    }
  });
  return 0;
}
