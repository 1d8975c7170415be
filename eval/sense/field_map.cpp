#include "eval/sense/field_map.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "eval/lab/map_source.hpp"
#include "worlds/hallway.hpp"
#include "worlds/map_file.hpp"
#include "worlds/truth_grid.hpp"

namespace cogslam {

namespace {

double value_of(MapCell cell) { return cell == MapCell::kOccupied ? 1.0 : cell == MapCell::kFree ? 0.0 : 0.5; }

FieldMap field_of(const OccupancyMap& occupancy, const std::filesystem::path& file) {
  FieldMap map{.name = file.stem().string(), .width = occupancy.width, .height = occupancy.height, .cells = {}};
  for (int y = map.height; y-- > 0;) {
    for (int x = 0; x < map.width; ++x) map.cells.push_back(value_of(occupancy.at({x, y})));
  }
  return map;
}

}  // namespace

FieldMap read_field_map(const std::filesystem::path& file) {
  const std::filesystem::path ending = file.extension();
  if (ending == ".yaml") return field_of(read_map_file(file), file);
  if (ending == ".pgm" || ending == ".png") return field_of(read_map_picture(file, 1.0), file);
  const Grid<float> grid = ending == ".npy" ? read_npy(file) : read_csv(file);
  FieldMap map{.name = file.stem().string(),
               .width = grid.frame().width,
               .height = grid.frame().height,
               .cells = {grid.values().begin(), grid.values().end()}};
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (map.cells[i] >= 0.0 && map.cells[i] <= 1.0) continue;
    throw InputError({file.string()}, "row " + std::to_string(i / width + 1) + ", value " +
                                          std::to_string(i % width + 1) + " is " + number_text(map.cells[i]) +
                                          ", expected 0 (free) to 1 (occupied)");
  }
  return map;
}

FieldMap hallway_field() {
  const Grid<TruthCell> truth = truth_grid(hallway(), 0.25);
  FieldMap map{.name = "hallway", .width = truth.frame().width, .height = truth.frame().height, .cells = {}};
  for (int y = map.height; y-- > 0;) {
    for (int x = 0; x < map.width; ++x) {
      const TruthCell cell = truth[{x, y}];
      map.cells.push_back(cell == TruthCell::kFree ? 0.0 : cell == TruthCell::kOccupied ? 1.0 : 0.5);
    }
  }
  return map;
}

}  // namespace cogslam
