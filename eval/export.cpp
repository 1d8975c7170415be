#include "eval/export.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <set>

#include "core/check.hpp"
#include "core/output_file.hpp"
#include "eval/metrics/map_error.hpp"
#include "worlds/map_file.hpp"

namespace cogslam {
namespace {

std::string stamp_text(Time stamp) {
  const std::int64_t second = 1'000'000'000;
  const std::int64_t whole = stamp.ns / second, rest = std::abs(stamp.ns % second);
  return fmt::format("{}{}.{:09}", stamp.ns < 0 && whole == 0 ? "-" : "", whole, rest);
}

MapCell map_cell(float log_odds) {
  switch (classify(static_cast<double>(log_odds))) {
    case CellClass::kFree:
      return MapCell::kFree;
    case CellClass::kOccupied:
      return MapCell::kOccupied;
    case CellClass::kUnknown:
      break;
  }
  return MapCell::kUnknown;
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

OccupancyMap ternary_map(const Grid<float>& log_odds) {
  std::vector<MapCell> cells;
  cells.reserve(log_odds.values().size());
  for (const float value : log_odds.values()) cells.push_back(map_cell(value));
  return map_on(log_odds.frame(), std::move(cells));
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
  const OccupancyMap map = ternary_map(log_odds);
  write_file(pgm, map_pgm_bytes(map));
  write_file(with_suffix(stem, ".yaml"), map_yaml_text(map, pgm.filename().string()));
  write_file(with_suffix(stem, ".npy"), map_npy_bytes(log_odds));
}

}  // namespace cogslam
