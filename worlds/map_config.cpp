#include "worlds/map_config.hpp"

#include <algorithm>

#include "core/printable.hpp"
#include "worlds/map_contours.hpp"
#include "worlds/map_file.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kLongestName = 1000;  // of a file, in messages

MapContourConfig read_contour_config(ConfigSection& section) {
  MapContourConfig config;
  section.read_choice("unknown", config.unknown_is_solid, {{"empty", false}, {"solid", true}});
  section.read("simplify_m", config.simplify, {0.0, 1.0});
  return config;
}

/// Into how many pieces surfaces are cut above and below each other's ends.
std::size_t count_pieces(const std::vector<Segment>& surfaces) {
  std::vector<double> ends;
  for (const Segment& s : surfaces) ends.insert(ends.end(), {s.a.x(), s.b.x()});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::size_t pieces = 0;
  for (const Segment& s : surfaces) {
    const auto [left, right] = std::minmax(s.a.x(), s.b.x());
    pieces += static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), right) -
                                       std::lower_bound(ends.begin(), ends.end(), left));
  }
  return pieces;
}

void check_surfaces(const ConfigSection& section, const std::filesystem::path& file,
                    const std::vector<Segment>& surfaces) {
  if (surfaces.empty()) section.fail("map", "map: no cell of " + file.string() + " is occupied, expected walls");
  if (surfaces.size() > kMostMapSurfaces) {
    section.fail("map", "map: " + std::to_string(surfaces.size()) + " surfaces, expected at most " +
                            std::to_string(kMostMapSurfaces) + ": simplify_m makes fewer");
  }
  if (count_pieces(surfaces) > kMostMapPieces) {
    section.fail("map", "map: " + std::to_string(surfaces.size()) +
                            " surfaces that are too long for their number, expected fewer: simplify_m makes them so");
  }
}

}  // namespace

World read_map_world(ConfigSection& section) {
  std::filesystem::path file;
  if (!section.has("map")) section.fail("map", "no 'map', expected the name of a map's YAML file");
  section.read("map", file);
  const MapContourConfig config = read_contour_config(section);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    section.fail("map", "map: there is no " + printable(file.string(), kLongestName));
  const auto map = std::make_shared<const OccupancyMap>(read_map_file(file));
  if (const std::size_t corners = count_corners(*map, config.unknown_is_solid); corners > kMostMapCorners) {
    section.fail("map", "map: its cells have " + std::to_string(corners) + " corners, expected a floor of at most " +
                            std::to_string(kMostMapCorners));
  }
  World world = map_contours(*map, config);
  check_surfaces(section, file, world.segments());
  world.map = map;
  return world;
}

void check_map_start(const ConfigSection& section, const World& world) {
  const MapCell cell = world.map->at(world.map->cell_of(world.start.position()));
  if (cell == MapCell::kOccupied) {
    section.fail("start", "start: an occupied cell of the map, expected a free one");
  }
}

}  // namespace cogslam
