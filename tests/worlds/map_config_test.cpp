#include "worlds/map_config.hpp"

#include <gtest/gtest.h>

#include "core/grid.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "worlds/clearance.hpp"
#include "worlds/free_space.hpp"
#include "worlds/map_contours.hpp"
#include "worlds/map_file.hpp"
#include "worlds/polygon.hpp"
#include "worlds/world_config.hpp"

namespace cogslam {
namespace {

/// 8 x 6 cells of 0.5 m from (-1, -1): walls one cell thick, a box of 2 x 1 cells, an unknown cell in the wall.
const std::string kRoom =
    "P2 8 6 255\n"
    "0 0 0 0 0 0 0 0\n"
    "0 254 254 254 254 254 254 0\n"
    "0 254 254 0 0 254 254 0\n"
    "0 254 254 254 254 254 254 0\n"
    "0 254 254 254 254 254 254 GAP\n"
    "0 0 0 0 0 0 0 0\n";

class MapWorld : public testing::Test {
 protected:
  void use(const std::string& gap = "0") {
    std::string pgm = kRoom;
    pgm.replace(pgm.find("GAP"), 3, gap);
    (void)folder_.file("room.pgm", pgm);
    (void)folder_.file("room.yaml", "image: room.pgm\nresolution: 0.5\norigin: [-1, -1, 0]\n");
  }
  [[nodiscard]] World world(const std::string& more) const {
    ConfigSection section = ConfigSection::load(folder_.file("world.yaml", "kind: map\nmap: room.yaml\n" + more));
    World read = read_world(section);
    section.finish();
    return read;
  }
  [[nodiscard]] std::string message(const std::string& more) const {
    std::string text = error_text([&] { (void)world(more); });
    const std::string name = folder_.path().string() + "/";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) text.erase(at, name.size());
    return text;
  }

  TemporaryFolder folder_;
};

TEST_F(MapWorld, RunsThroughTheCentresOfTheCellsAlongTheBorders) {
  use();
  const World room = world("");
  ASSERT_EQ(room.walls.size(), 2u) << "the outer and the inner border of the walls";
  for (const Polygon& wall : room.walls) EXPECT_NEAR(std::abs(signed_area(wall)), 3.5 * 2.5, 0.6);
  ASSERT_EQ(room.obstacles.size(), 1u);
  EXPECT_EQ(room.bounds().min, Eigen::Vector2d(-0.75, -0.75));
  EXPECT_EQ(room.bounds().max, Eigen::Vector2d(2.75, 1.75));
  EXPECT_NEAR(clearance(room, Eigen::Vector2d(1.0, -0.25)), 0.5, 1e-12) << "to the centres of the cells of the wall";
  EXPECT_NEAR(clearance(room, Eigen::Vector2d(1.0, 1.0)), 0.25, 1e-12) << "to the box, a line without thickness";
  EXPECT_TRUE(FreeSpace(room).is_closed());
  ASSERT_NE(room.map, nullptr);
  EXPECT_EQ(room.map->width, 8);
}

TEST_F(MapWorld, HasRoomForMoreObstaclesAndAStart) {
  use();
  const World room = world("start: {x_m: 1.5, y_m: 0, heading_deg: 90}\nobstacles: [{box: {x_m: 0, y_m: 1}}]\n");
  EXPECT_EQ(room.start.position(), Eigen::Vector2d(1.5, 0));
  EXPECT_EQ(room.obstacles.size(), 2u);
}

TEST_F(MapWorld, ClosesUnknownCellsOnRequest) {
  use("205");
  EXPECT_EQ(message(""),
            "world.yaml:1:1: the map's walls do not close around the start, expected a start inside them, or "
            "`unknown: solid`, which closes them");
  const World closed = world("unknown: solid\n");
  EXPECT_TRUE(FreeSpace(closed).is_closed());
  // Beyond the image all is unknown: a map that is free up to its border is closed there.
  use("254");
  EXPECT_TRUE(FreeSpace(world("unknown: solid\n")).is_closed());
  EXPECT_EQ(world("unknown: solid\n").bounds().max.x(), 3.25);
}

TEST_F(MapWorld, RefusesAStartInAnOccupiedCell) {
  use();
  EXPECT_EQ(message("start: {x_m: 0.8, y_m: 0.6}\n"),
            "world.yaml:3:1: start: an occupied cell of the map, expected a free one");
}

TEST_F(MapWorld, NamesTheMapThatIsNotThere) {
  EXPECT_EQ(message(""), "world.yaml:2:1: map: there is no room.yaml");
  EXPECT_EQ(error_text([] {
              ConfigSection section = ConfigSection::parse("kind: map\n", "w.yaml");
              (void)read_world(section);
            }),
            "w.yaml:1:1: no 'map', expected the name of a map's YAML file");
}

TEST_F(MapWorld, RefusesMapsThatAreEmptyOrTooLarge) {
  use();
  (void)folder_.file("room.pgm", "P2 1 1 255 254");
  EXPECT_EQ(message(""), "world.yaml:2:1: map: no cell of room.yaml is occupied, expected walls");
  (void)folder_.file("room.pgm", "P2 4 1 255 0 254 254 0");
  (void)folder_.file("room.yaml", "image: room.pgm\nresolution: 100\norigin: [-1, -1, 0]\n");
  EXPECT_EQ(message(""), "world.yaml:2:1: the world is larger than 200 m, expected at most 200 m each way");
}

TEST_F(MapWorld, RefusesMoreSurfacesThanItCanUse) {
  std::string pgm = "P2 300 300 255\n";
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) pgm += x % 2 == 0 && y % 2 == 0 ? "0 " : "254 ";
  }
  use();
  (void)folder_.file("room.pgm", pgm);
  EXPECT_EQ(message(""), "world.yaml:2:1: map: 90000 surfaces, expected at most 50000: simplify_m makes fewer");
}

TEST_F(MapWorld, RefusesLongSurfacesByTheThousandThatEndEverywhere) {
  use();
  constexpr int kSide = 4000;
  std::string pgm = "P5 4000 4000 255\n";
  for (int y = 0; y < kSide; ++y) {
    std::string row(kSide, static_cast<char>(y % 2 == 0 ? 0 : 254));
    if (y == 1) {
      for (std::size_t x = 0; x < kSide; x += 2) row[x] = 0;
    }
    pgm += row;
  }
  (void)folder_.file("room.pgm", pgm);
  (void)folder_.file("room.yaml", "image: room.pgm\nresolution: 0.05\norigin: [-1, -1, 0]\n");
  EXPECT_NE(message("").find("surfaces that are too long for their number"), std::string::npos) << message("");
}

TEST_F(MapWorld, ItsResolvedTextNamesTheMapFromItsOwnPlace) {
  use();
  ConfigSection section = ConfigSection::load(folder_.file("world.yaml", "kind: map\nmap: room.yaml\n"));
  (void)read_world(section);
  EXPECT_EQ(section.resolved().substr(0, 26), "kind: map\nmap: room.yaml\nu");
  std::filesystem::create_directory(folder_.path() / "below");
  ConfigSection below = ConfigSection::load(folder_.file("below/world.yaml", "kind: map\nmap: ../room.yaml\n"));
  (void)read_world(below);
  const std::string full = (folder_.path() / "room.yaml").string();
  EXPECT_EQ(below.resolved().substr(0, 15 + full.size()), "kind: map\nmap: " + ("\"" + full).substr(0, full.size()));
}

/// Staircases of a round wall.
OccupancyMap disc(double radius_cells, double resolution) {
  const int side = 2 * static_cast<int>(radius_cells) + 5;
  Grid<MapCell> grid({.cell_size = resolution, .width = side, .height = side}, MapCell::kFree);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (std::hypot(x - side / 2, y - side / 2) < radius_cells) grid[{x, y}] = MapCell::kOccupied;
    }
  }
  return map_on(grid.frame(), grid.values());
}

TEST(MapContours, CountsCornersBeforeItDraws) {
  constexpr MapCell o = MapCell::kFree, x = MapCell::kOccupied, u = MapCell::kUnknown;
  const auto count = [](int width, std::vector<MapCell> cells, bool unknown_is_solid = false) {
    const int height = static_cast<int>(cells.size()) / width;
    return count_corners({.width = width, .height = height, .cells = std::move(cells)}, unknown_is_solid);
  };
  EXPECT_EQ(count(1, {x}), 4u);
  EXPECT_EQ(count(2, {x, x, x, x}), 4u);
  EXPECT_EQ(count(2, {x, x, x, o}), 6u);
  EXPECT_EQ(count(2, {x, o, o, x}), 8u) << "two cells that touch at a corner";
  EXPECT_EQ(count(3, {x, x, x, x, o, x, x, x, x}), 8u) << "a hole";
  EXPECT_EQ(count(2, {u, o, o, o}), 0u);
  EXPECT_EQ(count(2, {u, o, o, o}, true), 6u) << "all beyond is solid too";
}

TEST(MapContours, SimplifiesWithinItsTolerance) {
  const OccupancyMap map = disc(60.3, 0.05);
  const World exact = map_contours(map);
  std::size_t before = exact.segments().size();
  for (const double tolerance : {0.03, 0.06, 0.2}) {
    const World simple = map_contours(map, {.simplify = tolerance});
    const std::vector<Segment> left = simple.segments();
    EXPECT_LT(left.size(), before);
    before = left.size();
    for (const Eigen::Vector2d& corner : exact.obstacles[0]) {
      double nearest = 1e9;
      for (const Segment& s : left) nearest = std::min(nearest, distance(s, corner));
      EXPECT_LE(nearest, tolerance + 1e-9);
    }
  }
}

TEST(MapContours, KeepsWhatIsSmallerThanTheTolerance) {
  const World world = map_contours(disc(0.5, 0.05), {.simplify = 1.0});
  ASSERT_EQ(world.obstacles.size(), 1u);
  EXPECT_NEAR(signed_area(world.obstacles[0]), 0.025 * 0.025, 1e-12) << "one cell: a box of half its side";
}

}  // namespace
}  // namespace cogslam
