// Learns the chances of the context code from maps and prints slam/codec/context_model_table.cpp:
//
//   tile_model MAP.npy [...] > slam/codec/context_model_table.cpp && clang-format -i slam/codec/context_model_table.cpp
//
// The maps are log-odds on the lattice of unit 0.4, as runs save them. The table that is built in was learned from the
// MIT CSAIL log (8 particles, cells of 0.1 and 0.05 m) and from the three rooms, not from the Intel log that the sizes
// are stated for.

#include <cstdio>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "slam/codec/context_code.hpp"
#include "slam/map/lattice.hpp"

namespace cogslam {
namespace {

struct PlainMap {
  int width = 0, height = 0;
  std::vector<float> values;
};

/// Reads the .npy files that this program writes: version 1.0, little-endian float32, row-major.
PlainMap read_npy(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> lead(10);
  file.read(lead.data(), 10);
  std::string header(
      static_cast<unsigned char>(lead[8]) | static_cast<std::size_t>(static_cast<unsigned char>(lead[9])) << 8, ' ');
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  PlainMap map;
  const std::size_t shape = header.find("'shape': (");
  if (!file || header.find("'<f4'") == std::string::npos || shape == std::string::npos ||
      std::sscanf(header.c_str() + shape, "'shape': (%d, %d)", &map.height, &map.width) != 2) {
    throw std::runtime_error(path + ": not a map of float32");
  }
  map.values.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  file.read(reinterpret_cast<char*>(map.values.data()),
            static_cast<std::streamsize>(map.values.size() * sizeof(float)));
  return map;
}

void add_tiles(const PlainMap& map, ContextCensus& census) {
  for (int y0 = 0; y0 < map.height; y0 += kTileSide) {
    for (int x0 = 0; x0 < map.width; x0 += kTileSide) {
      TileCells tile;
      for (int y = y0; y < std::min(y0 + kTileSide, map.height); ++y) {
        for (int x = x0; x < std::min(x0 + kTileSide, map.width); ++x) {
          tile.levels[static_cast<std::size_t>((y - y0) * kTileSide + x - x0)] =
              level_of(map.values[static_cast<std::size_t>(y * map.width + x)], LatticeModel{}.unit);
        }
      }
      if (tile != TileCells{}) census.add(tile);
    }
  }
}

void print_values(std::span<const BitChance> values) {
  std::printf("{");
  for (const BitChance value : values) std::printf("%u, ", static_cast<unsigned>(value));
  std::printf("},\n");
}

}  // namespace
}  // namespace cogslam

int main(int count, char** arguments) {
  cogslam::ContextCensus census;
  for (int i = 1; i < count; ++i) cogslam::add_tiles(cogslam::read_npy(arguments[i]), census);
  const cogslam::ContextModel model = census.model();
  std::printf("// Printed by bench/tile_model.\n\n#include \"slam/codec/context_code.hpp\"\n\nnamespace cogslam {\n\n");
  std::printf("const ContextModel& context_model() {\n  static constexpr ContextModel kModel{\n");
  cogslam::print_values(model.as_above);
  cogslam::print_values(model.as_before);
  cogslam::print_values(model.level);
  std::printf("};\n  return kModel;\n}\n\n}  // namespace cogslam\n");
  return 0;
}
