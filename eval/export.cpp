#include "eval/export.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <set>

#include "core/check.hpp"
#include "core/output_file.hpp"
#include "eval/metrics/map_error.hpp"

namespace cogslam {
namespace {

std::string stamp_text(Time stamp) {
  const std::int64_t second = 1'000'000'000;
  const std::int64_t whole = stamp.ns / second, rest = std::abs(stamp.ns % second);
  return fmt::format("{}{}.{:09}", stamp.ns < 0 && whole == 0 ? "-" : "", whole, rest);
}

char pixel(float log_odds) {
  switch (classify(static_cast<double>(log_odds))) {
    case CellClass::kFree:
      return static_cast<char>(254);
    case CellClass::kOccupied:
      return 0;
    case CellClass::kUnknown:
      break;
  }
  return static_cast<char>(205);
}

std::filesystem::path with_suffix(const std::filesystem::path& stem, const char* suffix) {
  return stem.parent_path() / (stem.filename().string() + suffix);
}

}  // namespace

std::string tum_text(std::span<const Time> stamps, std::span<const Pose2> path) {
  EXPECTS(stamps.size() == path.size());
  std::string text;
  std::set<double> written;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!written.insert(stamps[i].seconds()).second) continue;
    const Pose2& T = path[i];
    text += fmt::format("{} {} {} 0 0 0 {} {}\n", stamp_text(stamps[i]), T.x, T.y, std::sin(T.theta / 2.0),
                        std::cos(T.theta / 2.0));
  }
  return text;
}

void write_trajectory(const std::filesystem::path& file, std::span<const Time> stamps, std::span<const Pose2> path) {
  write_file(file, tum_text(stamps, path));
}

std::string map_pgm_bytes(const Grid<float>& log_odds) {
  const GridFrame& frame = log_odds.frame();
  std::string bytes = fmt::format("P5\n{} {}\n255\n", frame.width, frame.height);
  for (int y = frame.height - 1; y >= 0; --y) {
    for (int x = 0; x < frame.width; ++x) bytes += pixel(log_odds[{x, y}]);
  }
  return bytes;
}

std::string map_yaml_text(const GridFrame& frame, const std::string& image) {
  return fmt::format(
      "image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, 0.0]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
      image, frame.cell_size, frame.origin().x(), frame.origin().y());
}

std::string map_npy_bytes(const Grid<float>& log_odds) {
  const GridFrame& frame = log_odds.frame();
  std::string header =
      fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': ({}, {}), }}", frame.height, frame.width);
  const std::size_t before = 10;  // magic, version and length of the header; the data start at a multiple of 64
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFF);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  for (const float value : log_odds.values()) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((bits >> shift) & 0xFF);
  }
  return bytes;
}

void write_map(const std::filesystem::path& stem, const Grid<float>& log_odds) {
  const std::filesystem::path pgm = with_suffix(stem, ".pgm");
  write_file(pgm, map_pgm_bytes(log_odds));
  write_file(with_suffix(stem, ".yaml"), map_yaml_text(log_odds.frame(), pgm.filename().string()));
  write_file(with_suffix(stem, ".npy"), map_npy_bytes(log_odds));
}

}  // namespace cogslam
