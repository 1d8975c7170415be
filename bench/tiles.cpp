// The codes of tiles beside general compressors, on a map that was made from a log: bytes, and time per cell.
//
//   bench_tiles MAP.npy [...]     float32 log-odds on the lattice of unit 0.4, as `cogslam replay` saves them
//
// Without arguments the map is that of an office (bench/office.hpp).

#include <lz4.h>
#include <zstd.h>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/office.hpp"
#include "bench/plain_map.hpp"
#include "eval/metrics/timing.hpp"
#include "slam/codec/byte_code.hpp"
#include "slam/codec/coarse_cells.hpp"
#include "slam/codec/context_code.hpp"
#include "slam/codec/nibble_code.hpp"
#include "slam/map/inverse_sensor_model.hpp"
#include "slam/map/store.hpp"

namespace cogslam {
namespace {

using Code = std::vector<std::uint8_t>;

/// One way to write a tile down.
struct Scheme {
  const char* name;
  std::function<std::size_t(const TileCells&, Code&)> encode;  ///< returns the bytes used of the code
  std::function<bool(std::span<const std::uint8_t>, TileCells&)> decode;
};

template <class Buffer, class Encode>
std::size_t through(Code& code, Encode&& encode) {
  Buffer buffer;
  const std::size_t size = encode(buffer);
  std::copy_n(buffer.begin(), size, code.begin());
  return size;
}

std::vector<Scheme> schemes() {
  std::vector<Scheme> all;
  all.push_back({"nibble run lengths",
                 [](const TileCells& tile, Code& code) {
                   return through<NibbleBuffer>(code, [&](NibbleBuffer& to) { return encode_nibbles(tile, to); });
                 },
                 decode_nibbles});
  all.push_back({"byte run lengths",
                 [](const TileCells& tile, Code& code) {
                   return through<ByteBuffer>(code, [&](ByteBuffer& to) { return encode_bytes(tile, to); });
                 },
                 decode_bytes});
  all.push_back({"neighbour contexts",
                 [](const TileCells& tile, Code& code) {
                   return through<ContextBuffer>(
                       code, [&](ContextBuffer& to) { return encode_contexts(tile, true, to).value(); });
                 },
                 [](auto code, TileCells& tile) { return decode_contexts(code, true, tile); }});
  all.push_back({"LZ4",
                 [](const TileCells& tile, Code& code) {
                   return static_cast<std::size_t>(LZ4_compress_default(
                       reinterpret_cast<const char*>(tile.levels.data()), reinterpret_cast<char*>(code.data()),
                       kTileCells, static_cast<int>(code.size())));
                 },
                 [](auto code, TileCells& tile) {
                   return LZ4_decompress_safe(reinterpret_cast<const char*>(code.data()),
                                              reinterpret_cast<char*>(tile.levels.data()),
                                              static_cast<int>(code.size()), kTileCells) == kTileCells;
                 }});
  for (const int level : {1, 19}) {
    all.push_back({level == 1 ? "zstd -1" : "zstd -19",
                   [level](const TileCells& tile, Code& code) {
                     return ZSTD_compress(code.data(), code.size(), tile.levels.data(), kTileCells, level);
                   },
                   [](auto code, TileCells& tile) {
                     return ZSTD_decompress(tile.levels.data(), kTileCells, code.data(), code.size()) == kTileCells;
                   }});
  }
  return all;
}

/// Best of five rounds over all tiles [s].
double best_time(const std::function<void()>& round) {
  double best = 1e9;
  for (int i = 0; i < 5; ++i) {
    const Stopwatch watch(Clock::kThreadCpu);
    round();
    best = std::min(best, watch.seconds());
  }
  return best;
}

void measure(const Scheme& scheme, const std::vector<TileCells>& tiles, double rectangle) {
  std::vector<Code> codes(tiles.size(), Code(4096));
  std::vector<std::size_t> sizes(tiles.size());
  const int repeats = 10;
  const double encoding = best_time([&] {
    for (int r = 0; r < repeats; ++r) {
      for (std::size_t t = 0; t < tiles.size(); ++t) sizes[t] = scheme.encode(tiles[t], codes[t]);
    }
  });
  std::size_t bytes = 0, wrong = 0;
  for (const std::size_t size : sizes) bytes += size;
  TileCells back;
  const double decoding = best_time([&] {
    for (int r = 0; r < repeats; ++r) {
      for (std::size_t t = 0; t < tiles.size(); ++t) {
        wrong += scheme.decode({codes[t].data(), sizes[t]}, back) && back == tiles[t] ? 0 : 1;
      }
    }
  });
  const double cells = static_cast<double>(tiles.size()) * kTileCells * repeats;
  std::printf("%-20s %8zu %8.4f %8.2f %8.1f %8.2f %8.2f%s\n", scheme.name, bytes,
              static_cast<double>(bytes) / rectangle, 25.0 * static_cast<double>(bytes) / rectangle,
              static_cast<double>(bytes) / static_cast<double>(tiles.size()), 1e9 * encoding / cells,
              1e9 * decoding / cells, wrong == 0 ? "" : "  WRONG");
}

void compare(const std::string& name, const Grid<float>& map, double rectangle) {
  const std::vector<TileCells> tiles = bench::tiles_of(map);
  std::printf("\n%s: %zu tiles; bytes per cell and %% of float32 over %.0f cells\n", name.c_str(), tiles.size(),
              rectangle);
  std::printf("%-20s %8s %8s %8s %8s %8s %8s\n", "code", "bytes", "per cell", "% float", "per tile", "enc ns",
              "dec ns");
  for (const Scheme& scheme : schemes()) measure(scheme, tiles, rectangle);
}

Grid<float> office_map() {
  const auto meter = std::make_shared<MemoryMeter>();
  MapStore map({.kind = StoreKind::kLattice}, bench::Office::kCell, std::nullopt, meter);
  MapScratch scratch;
  MapUpdater updater;
  Rng rng({.seed = 1, .purpose = Purpose::kWorld});
  for (int i = 0; i < 200; ++i) {
    Pose2 pose = bench::Office::door(i / 5 % 5, i / 25, 0.7 * i);
    pose.x += 0.7 * (i % 5);
    const std::vector<Beam> sweep = bench::Office::scan(pose, rng);
    map.load(window_of(sweep, pose, bench::Office::kCell), scratch);
    map.commit(updater.integrate(sweep, pose, LogOddsModel{}, scratch.log_odds), scratch);
  }
  map.load(map.extent(), scratch);
  return scratch.log_odds;
}

}  // namespace
}  // namespace cogslam

int main(int count, char** arguments) {
  for (int i = 1; i < count; ++i) {
    const cogslam::Grid<float> map = cogslam::bench::read_npy(arguments[i]);
    cogslam::compare(arguments[i], map, map.frame().width > 500 ? 640.0 * 640.0 : 320.0 * 320.0);
  }
  if (count == 1) {
    const cogslam::Grid<float> map = cogslam::office_map();
    cogslam::compare("office", map, static_cast<double>(map.frame().size()));
  }
  return 0;
}
