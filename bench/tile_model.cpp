// Learns the chances of the context code from maps and prints slam/codec/context_model_table.cpp:
//
//   tile_model MAP.npy [...] > slam/codec/context_model_table.cpp && clang-format -i slam/codec/context_model_table.cpp
//
// The maps are log-odds on the lattice of unit 0.4, as runs save them. The table that is built in was learned from the
// MIT CSAIL log (8 particles, cells of 0.1 and 0.05 m) and from two rooms, not from the Intel log that the sizes
// are stated for.

#include <cstdio>
#include <span>

#include "bench/plain_map.hpp"
#include "slam/codec/context_code.hpp"

namespace cogslam {
namespace {

void print_values(std::span<const BitChance> values) {
  std::printf("{");
  for (const BitChance value : values) std::printf("%u, ", static_cast<unsigned>(value));
  std::printf("},\n");
}

}  // namespace
}  // namespace cogslam

int main(int count, char** arguments) {
  cogslam::ContextCensus census;
  for (int i = 1; i < count; ++i) {
    for (const cogslam::TileCells& tile : cogslam::bench::tiles_of(cogslam::bench::read_npy(arguments[i])))
      census.add(tile);
  }
  const cogslam::ContextModel model = census.model();
  std::printf("// Printed by bench/tile_model.\n\n#include \"slam/codec/context_code.hpp\"\n\nnamespace cogslam {\n\n");
  std::printf("namespace {\n\nconstexpr ContextModel kModel{\n");
  cogslam::print_values(model.as_above);
  cogslam::print_values(model.as_before);
  cogslam::print_values(model.level);
  std::printf(
      "};\n\n}  // namespace\n\nconst ContextModel& context_model() { return kModel; }\n\n}  // namespace cogslam\n");
  return 0;
}
