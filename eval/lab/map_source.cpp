#include "eval/lab/map_source.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/check.hpp"
#include "core/config.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/text_file.hpp"
#include "slam/map/log_odds.hpp"
#include "worlds/rooms.hpp"
#include "worlds/truth_grid.hpp"

namespace cogslam {
namespace {

constexpr double kFileCellSize = 0.1;  // files do not say; the laboratory counts cells, not metres

const std::array<std::pair<const char*, std::function<World()>>, 3>& rooms() {
  static const std::array<std::pair<const char*, std::function<World()>>, 3> kRooms{
      {{"simple", [] { return simple_room(); }},
       {"cornered", [] { return cornered_room(); }},
       {"cluttered", [] { return cluttered_room(); }}}};
  return kRooms;
}

/// Appends the numbers of a line to `values` and returns how many there were.
std::size_t read_row(std::string_view line, SourcePlace place, std::vector<float>& values) {
  std::size_t count = 0;
  for (std::size_t begin = 0; begin <= line.size(); ++count) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::string_view field = line.substr(begin, end - begin);
    while (field.starts_with(' ')) field.remove_prefix(1);
    while (field.ends_with(' ')) field.remove_suffix(1);
    const auto value = parse_number(field);
    if (!value) {
      place.column = static_cast<int>(begin) + 1;
      throw InputError(place, "expected a number, found " + in_quotes(field));
    }
    if (std::abs(*value) > static_cast<double>(std::numeric_limits<float>::max())) {
      place.column = static_cast<int>(begin) + 1;
      throw InputError(place, "expected a number in the range of a float, found " + in_quotes(field));
    }
    values.push_back(static_cast<float>(*value));
    begin = end + 1;
  }
  return count;
}

}  // namespace

Grid<float> read_csv(const std::filesystem::path& file) {
  LineReader reader(file);
  std::vector<float> values;
  std::size_t width = 0, height = 0;
  while (reader.next()) {
    if (reader.line().empty()) continue;
    const std::size_t count = read_row(reader.line(), reader.place(), values);
    if (values.size() > kMostFileCells) throw InputError(reader.place(), "too many values, expected at most 67108864");
    if (height++ == 0) width = count;
    if (count != width) {
      throw InputError(reader.place(), std::to_string(count) + " values in this row, expected " +
                                           std::to_string(width) + " as in the first");
    }
  }
  if (height == 0) throw InputError({file.string()}, "no values, expected a row of numbers per line");
  Grid<float> map({.cell_size = kFileCellSize, .width = static_cast<int>(width), .height = static_cast<int>(height)});
  map.values() = std::move(values);
  return map;
}

Grid<float> ideal_room_map(const std::string& room, double cell_size) {
  std::vector<std::string> names;
  for (const auto& [name, make] : rooms()) {
    names.emplace_back(name);
    if (room != name) continue;
    const Grid<TruthCell> truth = truth_grid(make(), cell_size);
    const LogOddsModel model;
    Grid<float> map(truth.frame());
    for (std::size_t i = 0; i < truth.values().size(); ++i) {
      const TruthCell cell = truth.values()[i];
      map.values()[i] = cell == TruthCell::kFree ? model.min : cell == TruthCell::kOccupied ? model.max : 0.0F;
    }
    return map;
  }
  const std::string near = nearest_name(room, names);
  throw InputError(room + ": neither a file nor a room, expected a .npy or .csv file, or one of simple, cornered, " +
                   "cluttered" + (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

Grid<float> lab_map(const std::string& name, double cell_size) {
  const std::filesystem::path file(name);
  if (file.extension() == ".npy") return read_npy(file);
  std::error_code ignored;
  if (symlink_status(file, ignored).type() != std::filesystem::file_type::not_found || file.extension() == ".csv")
    return read_csv(file);
  return ideal_room_map(name, cell_size);
}

Grid<float> centred_in(const Grid<float>& map, int width, int height) {
  const GridFrame& inner = map.frame();
  EXPECTS(width >= inner.width && height >= inner.height);
  const int left = (width - inner.width) / 2, below = (height - inner.height) / 2;
  Grid<float> result({.cell_size = inner.cell_size,
                      .lattice_min = {inner.lattice_min.x - left, inner.lattice_min.y - below},
                      .width = width,
                      .height = height});
  for (int y = 0; y < inner.height; ++y) {
    for (int x = 0; x < inner.width; ++x) result[{x + left, y + below}] = map[{x, y}];
  }
  return result;
}

}  // namespace cogslam
