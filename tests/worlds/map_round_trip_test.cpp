// Write a map, read it as a world, rasterise it at the same cell size: the same occupied cells, whatever the map.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/output_file.hpp"
#include "core/rng.hpp"
#include "tests/support/temporary_folder.hpp"
#include "worlds/map_contours.hpp"
#include "worlds/map_file.hpp"
#include "worlds/rooms.hpp"
#include "worlds/truth_grid.hpp"
#include "worlds/world_map.hpp"

namespace cogslam {
namespace {

/// A map from a drawing, its top row first: '#' occupied, '.' free, '?' unknown.
OccupancyMap drawn_map(const std::vector<std::string>& rows, double resolution = 0.1) {
  const int width = static_cast<int>(rows.front().size()), height = static_cast<int>(rows.size());
  std::vector<MapCell> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      cells.push_back(c == '#' ? MapCell::kOccupied : c == '.' ? MapCell::kFree : MapCell::kUnknown);
    }
  }
  return map_on({.cell_size = resolution, .lattice_min = {-3, 5}, .width = width, .height = height}, cells);
}

std::vector<std::uint8_t> occupied(const OccupancyMap& map) {
  std::vector<std::uint8_t> out;
  for (const MapCell cell : map.cells) out.push_back(cell == MapCell::kOccupied ? 1 : 0);
  return out;
}

/// A start beyond the map, as that of a world whose walls have an inside.
World outside(World world) {
  world.start = {-500.0, -500.0, 0.0};
  return world;
}

/// Cells drawn alone, boxes, and lines in both diagonals: holes, islands in holes, touching corners, borders.
OccupancyMap random_map(std::uint32_t seed) {
  Rng rng({seed, Purpose::kWorld, 0, 0});
  const auto below = [&rng](int n) { return std::min(static_cast<int>(rng.uniform(0.0, n)), n - 1); };
  constexpr double kSizes[] = {0.05, 0.1, 0.2, 0.03, 0.07, 1.0};
  const GridFrame frame{.cell_size = kSizes[below(6)],
                        .lattice_min = {below(2000) - 1000, below(2000) - 1000},
                        .width = 1 + below(40),
                        .height = 1 + below(40)};
  Grid<MapCell> grid(frame, MapCell::kFree);
  const double density = rng.uniform(0.0, 0.9);
  const int style = below(3);
  for (MapCell& cell : grid.values()) {
    const double draw = rng.uniform(0.0, 1.0);
    if (style == 0) cell = draw < density ? MapCell::kOccupied : draw < 0.95 ? MapCell::kFree : MapCell::kUnknown;
  }
  for (int i = 0; style != 0 && i < 8; ++i) {
    const Cell at{below(frame.width), below(frame.height)};
    const int width = 1 + below(12), height = style == 1 ? 1 + below(12) : 1;
    const int slope = style == 1 ? 0 : below(3) - 1;
    const MapCell value = below(3) == 0 ? MapCell::kFree : MapCell::kOccupied;  // a hole now and then
    for (int x = 0; x < width; ++x) {
      for (int y = 0; y < height; ++y) {
        const Cell c{at.x + x, at.y + y + slope * x};
        if (frame.contains(c)) grid[c] = value;
      }
    }
  }
  return map_on(frame, grid.values());
}

TEST(MapRoundTrip, KeepsEveryOccupiedCellOfRandomMaps) {
  const TemporaryFolder folder;
  std::size_t occupied_cells = 0, hidden = 0;
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    const OccupancyMap map = random_map(seed);
    OccupancyMap read = map;
    if (seed % 10 == 0) {  // the files themselves need no thousand tries
      write_file(folder.path() / "map.pgm", map_pgm_bytes(map));
      read = read_map_file(folder.file("map.yaml", map_yaml_text(map, "map.pgm")));
    }
    ASSERT_EQ(read, map) << "seed " << seed;
    const World world = outside(map_contours(read));
    const GridFrame frame = *map.frame();
    const std::vector<std::uint8_t> expected = occupied(map);
    ASSERT_EQ(solid_cells(world, frame), expected) << "seed " << seed;
    // No surface leaves the occupied cells, so neither does what a scan of them hits.
    const Grid<std::uint8_t> crossed = crossed_cells(world, frame);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_LE(crossed.values()[i], expected[i]) << "seed " << seed;
      occupied_cells += expected[i];
      hidden += expected[i] - crossed.values()[i];
    }
  }
  EXPECT_GT(occupied_cells, 200'000U);
  EXPECT_GT(hidden, 1'000U) << "cells within thick walls were tried, too";
}

TEST(MapRoundTrip, KeepsCornersHolesIslandsAndBorders) {
  for (const std::vector<std::string>& rows : {std::vector<std::string>{"#"},
                                               {"#.", ".#"},
                                               {".#", "#."},
                                               {"#.#", ".#.", "#.#"},
                                               {".#.", "#.#", ".#."},
                                               {"#####", "#...#", "#.#.#", "#...#", "#####"},
                                               {"######", "######", "##..##", "##..##", "######"},
                                               {"#########", "#.......#", "#.#####.#", "#.#...#.#", "#.#.#.#.#",
                                                "#.#...#.#", "#.#####.#", "#.......#", "#########"}}) {
    const OccupancyMap map = drawn_map(rows);
    EXPECT_EQ(solid_cells(outside(map_contours(map)), *map.frame()), occupied(map)) << rows[0] << " " << rows.size();
  }
}

TEST(MapRoundTrip, GivesBackTheWholeMapOfAClosedRoom) {
  const OccupancyMap map =
      drawn_map({"??#######", "?##.....#", "##..##..#", "#..####.#", "#...##..#", "##......#", "?########"});
  World world = map_contours(map);
  world.start = {map.point({2.5, 2.5}).x(), map.point({2.5, 2.5}).y(), 0.0};
  EXPECT_EQ(world_map(world, *map.frame()), map);
}

TEST(MapRoundTrip, EndsAfterOneRoundForRoomsMadeByHand) {
  for (const World& room : {simple_room(), cornered_room(), cluttered_room()}) {
    for (const double cell_size : {0.05, 0.1, 0.2}) {
      const OccupancyMap map = world_map(room, cell_size);
      World again = map_contours(map);
      again.start = room.start;
      EXPECT_EQ(world_map(again, *map.frame()), map);
    }
  }
}

}  // namespace
}  // namespace cogslam
