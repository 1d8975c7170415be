#include "worlds/world_map.hpp"

#include <algorithm>

#include "worlds/free_space.hpp"
#include "worlds/polygon.hpp"
#include "worlds/truth_grid.hpp"

namespace cogslam {
namespace {

/// Marks the cells of row `y` that lie inside an odd number of loops at the height of `p_y` [m].
void mark_inside(const std::vector<Segment>& sides, double p_y, int y, Grid<std::uint8_t>& inside) {
  std::vector<double> crossings;
  for (const Segment& s : sides) {
    if ((s.a.y() > p_y) == (s.b.y() > p_y)) continue;
    crossings.push_back(s.a.x() + (p_y - s.a.y()) * (s.b.x() - s.a.x()) / (s.b.y() - s.a.y()));
  }
  std::sort(crossings.begin(), crossings.end());
  std::size_t passed = 0;
  for (int x = 0; x < inside.frame().width; ++x) {
    const double p_x = inside.frame().centre_of({x, y}).x();
    while (passed < crossings.size() && crossings[passed] <= p_x) ++passed;
    inside[{x, y}] = passed % 2;
  }
}

/// Cells whose centre lies inside an odd number of loops; where a surface runs through it the answer may be either.
Grid<std::uint8_t> inside_of(const std::vector<Polygon>& loops, const GridFrame& frame) {
  std::vector<Segment> sides;
  for (const Polygon& loop : loops) {
    const std::vector<Segment> more = edges(loop);
    sides.insert(sides.end(), more.begin(), more.end());
  }
  Grid<std::uint8_t> inside(frame);
  for (int y = 0; y < frame.height; ++y) {
    mark_inside(sides, frame.centre_of({0, y}).y(), y, inside);
  }
  return inside;
}

}  // namespace

bool walls_are_thick(const World& world) {
  bool odd = false;
  for (const Polygon& wall : world.walls) odd ^= inside(wall, world.start.position());
  return !odd;
}

std::vector<std::uint8_t> solid_cells(const World& world, const GridFrame& frame) {
  Grid<std::uint8_t> solid = inside_of(world.obstacles, frame);
  if (walls_are_thick(world)) {
    const Grid<std::uint8_t> in_walls = inside_of(world.walls, frame);
    for (std::size_t i = 0; i < frame.size(); ++i) solid.values()[i] |= in_walls.values()[i];
  }
  const Grid<std::uint8_t> crossed = crossed_cells(world, frame);
  for (std::size_t i = 0; i < frame.size(); ++i) solid.values()[i] |= crossed.values()[i];
  return solid.values();
}

OccupancyMap world_map(const World& world, const GridFrame& frame) {
  const std::vector<std::uint8_t> solid = solid_cells(world, frame);
  const FreeSpace free_space(world);
  std::vector<MapCell> cells(frame.size(), MapCell::kOccupied);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const Cell c{x, y};
      if (solid[frame.index(c)] != 0) continue;
      cells[frame.index(c)] = free_space.contains(frame.centre_of(c)) ? MapCell::kFree : MapCell::kUnknown;
    }
  }
  return map_on(frame, std::move(cells));
}

OccupancyMap world_map(const World& world, double cell_size) {
  return world_map(world, GridFrame::covering(world.bounds(), cell_size));
}

}  // namespace cogslam
