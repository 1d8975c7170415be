#include "worlds/truth_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/check.hpp"
#include "tests/support/slow_truth_grid.hpp"
#include "worlds/rooms.hpp"

namespace cogslam {
namespace {

/// The grid as text, top row first: '.' free, '#' occupied, '?' unobservable.
std::vector<std::string> picture(const Grid<TruthCell>& grid) {
  std::vector<std::string> rows;
  for (int y = grid.frame().height; y-- > 0;) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < grid.frame().width; ++x) row += ".#?"[static_cast<int>(grid[{x, y}])];
  }
  return rows;
}

World rectangle_world(double left, double bottom, double right, double top) {
  return {.walls = {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}},
          .start = {0.5 * (left + right), 0.5 * (bottom + top), 0.0}};
}

std::vector<World> sample_rooms() {
  std::vector<World> rooms{simple_room(), cornered_room(), cluttered_room()};
  for (std::uint32_t variant = 1; variant <= 6; ++variant) {
    rooms.push_back(simple_room(kSimpleSize, variant));
    rooms.push_back(cornered_room(kCorneredSize, variant));
    rooms.push_back(cluttered_room(kCorneredSize, variant));
  }
  return rooms;
}

Rectangle area_of(const GridFrame& frame, Cell c) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * frame.cell_size);
  return {frame.centre_of(c) - half, frame.centre_of(c) + half};
}

TEST(TruthGrid, DrawsARoomWithABox) {
  World world = rectangle_world(0.25, 0.25, 7.75, 5.75);
  world.obstacles = {{{2.5, 1.5}, {4.5, 1.5}, {4.5, 3.5}, {2.5, 3.5}}};
  world.start = {1.5, 4.5, 0.0};
  EXPECT_EQ(picture(truth_grid(world, 1.0)), (std::vector<std::string>{"########",  //
                                                                       "#......#",  //
                                                                       "#.###..#",  //
                                                                       "#.#?#..#",  //
                                                                       "#.###..#",  //
                                                                       "########"}));
}

TEST(TruthGrid, GivesASurfaceOnABorderToTheCellAboveAndRight) {
  // In 0.1 m cells all these lie on borders, though none of 0.3, 0.6, 0.7 divides by 0.1 without rounding.
  World world = rectangle_world(0.05, 0.05, 0.95, 0.95);
  world.obstacles = {{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.6}, {0.3, 0.6}}};
  world.start = {0.15, 0.15, 0.0};
  EXPECT_EQ(picture(truth_grid(world, 0.1)), (std::vector<std::string>{"##########",  //
                                                                       "#........#",  //
                                                                       "#........#",  //
                                                                       "#..#####.#",  //
                                                                       "#..#???#.#",  //
                                                                       "#..#???#.#",  //
                                                                       "#..#####.#",  //
                                                                       "#........#",  //
                                                                       "#........#",  //
                                                                       "##########"}));
}

TEST(TruthGrid, MarksADiagonalThroughCornersWithoutItsNeighbours) {
  // All four sides run through cell corners, where the two cells beside a side are only touched.
  World world = rectangle_world(0.5, 0.5, 7.5, 7.5);
  world.obstacles = {{{2.0, 4.0}, {4.0, 2.0}, {6.0, 4.0}, {4.0, 6.0}}};
  world.start = {1.5, 1.5, 0.0};
  const std::vector<std::string> expected{"########",  //
                                          "#...#..#",  //
                                          "#..##..#",  //
                                          "#.#??###",  //
                                          "#.#??#.#",  //
                                          "#..##..#",  //
                                          "#......#",  //
                                          "########"};
  EXPECT_EQ(picture(truth_grid(world, 1.0)), expected);
  std::reverse(world.obstacles[0].begin(), world.obstacles[0].end());
  EXPECT_EQ(picture(truth_grid(world, 1.0)), expected) << "whichever way the sides run";
}

TEST(TruthGrid, SeesNoWayThroughADoorThatIsClosedHoweverCoarse) {
  // The right half can be reached only in the second world, through a gap of 2 mm; its cells measure a metre.
  World closed = rectangle_world(0.25, 0.25, 7.75, 3.75);
  closed.walls.push_back({{3.5, 0.25}, {3.6, 0.25}, {3.6, 3.75}, {3.5, 3.75}});
  closed.start = {1.5, 1.5, 0.0};
  World open = closed;
  open.walls.back()[0].y() = open.walls.back()[1].y() = 0.252;
  EXPECT_EQ(picture(truth_grid(closed, 1.0))[1], "#..#???#");
  EXPECT_EQ(picture(truth_grid(open, 1.0))[1], "#..#...#");
}

TEST(TruthGrid, AgreesWithClippingEverySurfaceAgainstEveryCell) {
  std::size_t checked = 0, undecided = 0;
  for (const World& world : sample_rooms()) {
    for (const double cell_size : {1.0, 0.5, 0.2, 0.1}) {
      const Grid<TruthCell> grid = truth_grid(world, cell_size);
      for (int y = 0; y < grid.frame().height; ++y) {
        for (int x = 0; x < grid.frame().width; ++x) {
          const PossibleTruth expected = slow_truth(world, area_of(grid.frame(), {x, y}));
          ASSERT_TRUE(expected.allows(grid[{x, y}])) << "cell " << x << ", " << y << " of " << cell_size << " m";
          ++checked;
          undecided += expected.may_be_occupied != expected.must_be_occupied;
        }
      }
    }
  }
  EXPECT_GT(checked, 50000u);
  EXPECT_LT(undecided, checked / 1000);
}

TEST(TruthGrid, IsConsistentBetweenCellSizes) {
  const std::vector<std::pair<double, int>> pairs{{1.0, 2}, {1.0, 5}, {0.5, 5}, {0.2, 2},
                                                  {0.2, 4}, {0.1, 2}, {1.0, 20}};
  for (const World& world : sample_rooms()) {
    for (const auto& [coarse_size, parts] : pairs) {
      const Grid<TruthCell> coarse = truth_grid(world, coarse_size), fine = truth_grid(world, coarse_size / parts);
      for (int y = 0; y < fine.frame().height; ++y) {
        for (int x = 0; x < fine.frame().width; ++x) {
          const auto part_of = [parts = parts](int lattice, int coarse_min) {
            return static_cast<int>(std::floor(static_cast<double>(lattice) / parts)) - coarse_min;
          };
          const Cell c{part_of(x + fine.frame().lattice_min.x, coarse.frame().lattice_min.x),
                       part_of(y + fine.frame().lattice_min.y, coarse.frame().lattice_min.y)};
          ASSERT_TRUE(coarse.frame().contains(c));
          // Occupied parts make an occupied whole; what is free or hidden as a whole is so in every part.
          const TruthCell part = fine[{x, y}];
          ASSERT_TRUE(coarse[c] == TruthCell::kOccupied || coarse[c] == part);
        }
      }
    }
  }
}

TEST(TruthGrid, AreasConvergeToThoseOfTheRoom) {
  for (const World& world : sample_rooms()) {
    double area = signed_area(world.walls.front()), surface = 0.0;
    for (const Polygon& box : world.obstacles) area -= signed_area(box);
    const std::vector<Segment> surfaces = world.segments();
    for (const Segment& s : surfaces) surface += (s.b - s.a).norm();
    for (const double cell_size : {0.5, 0.2, 0.1, 0.05}) {
      const Grid<TruthCell> grid = truth_grid(world, cell_size);
      double free_area = 0.0, occupied_area = 0.0;
      for (const TruthCell cell : grid.values()) {
        free_area += cell == TruthCell::kFree ? cell_size * cell_size : 0.0;
        occupied_area += cell == TruthCell::kOccupied ? cell_size * cell_size : 0.0;
      }
      EXPECT_LE(free_area, area);
      EXPECT_GE(free_area + occupied_area, area);
      // A surface of length l crosses at most sqrt(2) l / cell + 3 cells.
      const double crossed = std::numbers::sqrt2 * surface / cell_size + 3.0 * static_cast<double>(surfaces.size());
      EXPECT_LE(occupied_area, crossed * cell_size * cell_size);
    }
  }
}

TEST(TruthGrid, WantsAPositiveCellSize) { EXPECT_THROW(truth_grid(simple_room(), 0.0), ContractViolation); }

}  // namespace
}  // namespace cogslam
