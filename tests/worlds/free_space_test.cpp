#include "worlds/free_space.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "core/rng.hpp"
#include "worlds/polygon.hpp"

namespace cogslam {
namespace {

Polygon rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// One box of 1 m per '#', 'S' the start; top row first.
World world_of(const std::vector<std::string>& rows) {
  World world;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const double y = static_cast<double>(rows.size() - 1 - r);
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const double x = static_cast<double>(c);
      if (rows[r][c] == '#') world.obstacles.push_back(rectangle(x, y, x + 1.0, y + 1.0));
      if (rows[r][c] == 'S') world.start = {x + 0.5, y + 0.5, 0.0};
    }
  }
  return world;
}

/// Expects '.' and 'S' to be free and everything else not.
void expect_free_where_dotted(const std::vector<std::string>& rows) {
  const FreeSpace free_space(world_of(rows));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const Eigen::Vector2d p{static_cast<double>(c) + 0.5, static_cast<double>(rows.size() - r) - 0.5};
      EXPECT_EQ(free_space.contains(p), rows[r][c] == '.' || rows[r][c] == 'S') << "row " << r << ", column " << c;
    }
  }
}

TEST(FreeSpace, FollowsALabyrinth) {
  expect_free_where_dotted({"###########",  //
                            "#S....#  ##",  //
                            "#.###.# # #",  //
                            "#.# #.# ###",  //
                            "#.###.#####",  //
                            "#.........#",  //
                            "###########"});
}

TEST(FreeSpace, DoesNotSlipThroughTouchingCorners) {
  expect_free_where_dotted({"#######",  //
                            "#S.#  #",  //
                            "#.#   #",  //
                            "##  # #",  //
                            "#######"});
}

TEST(FreeSpace, SaysWhetherTheStartIsEnclosed) {
  EXPECT_TRUE(FreeSpace(world_of({"###", "#S#", "###"})).is_closed());
  EXPECT_FALSE(FreeSpace(world_of({"###", "#S.", "###"})).is_closed());
  EXPECT_FALSE(FreeSpace(world_of({"###S", "# #.", "###."})).is_closed());
}

TEST(FreeSpace, FindsThePocketBetweenABoxAndTheWallItOverlaps) {
  World world{.walls = {rectangle(0, 0, 10, 10)}, .start = {2, 8, 0}};
  world.obstacles = {{{8, 4}, {10.5, 2}, {10.5, 6}}, {{4, -1}, {6, 2}, {8, -1}, {6, 1}}};
  const FreeSpace free_space(world);
  EXPECT_TRUE(free_space.is_closed());
  EXPECT_TRUE(free_space.contains({7.5, 4}));
  EXPECT_FALSE(free_space.contains({9.0, 4}));
  EXPECT_FALSE(free_space.contains({6, 0.5})) << "between the wall and the arch that stands across it";
  EXPECT_FALSE(free_space.contains({6, 1.5}));
  EXPECT_TRUE(free_space.contains({6, 2.5}));
}

TEST(FreeSpace, LeaksThroughAGapOfAMicronButNotOfARoundingError) {
  const auto leaks = [](double gap) {
    World world{.walls = {rectangle(0, 0, 4, 4)}, .start = {1, 1, 0}};
    world.obstacles = {{{2, gap}, {2.1, gap}, {2.3, 4}, {2.2, 4}}};
    return FreeSpace(world).contains({3, 1});
  };
  EXPECT_TRUE(leaks(1e-6));
  EXPECT_FALSE(leaks(1e-12));
  EXPECT_FALSE(leaks(0.0));
  EXPECT_FALSE(leaks(-1e-6));
}

constexpr int kSide = 12;

/// Rectangles with whole coordinates, many of them touching, in a closed square; and what a flood of unit squares says.
struct LatticeCase {
  World world;
  std::array<std::array<bool, kSide>, kSide> reached{};
};

bool wall_between(const World& world, const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  for (const Segment& s : world.segments()) {
    if (touch(s, {p, q})) return true;
  }
  return false;
}

void flood(LatticeCase& lattice, int x, int y) {
  if (lattice.reached[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]) return;
  lattice.reached[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = true;
  constexpr std::array<std::array<int, 2>, 4> kWays{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  for (const auto& way : kWays) {
    const Eigen::Vector2d here{x + 0.5, y + 0.5}, there{x + way[0] + 0.5, y + way[1] + 0.5};
    if (!wall_between(lattice.world, here, there)) flood(lattice, x + way[0], y + way[1]);
  }
}

LatticeCase lattice_case(std::uint32_t seed) {
  Rng rng({.seed = seed, .purpose = Purpose::kWorld});
  LatticeCase out{.world = {.walls = {rectangle(0, 0, kSide, kSide)}}};
  for (int i = 0; i < 14; ++i) {
    const int left = static_cast<int>(rng.below(kSide)), bottom = static_cast<int>(rng.below(kSide));
    const int width = 1 + static_cast<int>(rng.below(5)), length = 1 + static_cast<int>(rng.below(5));
    const int right = std::min(left + width, kSide), top = std::min(bottom + length, kSide);
    out.world.obstacles.push_back(rectangle(left, bottom, right, top));
  }
  const int x = static_cast<int>(rng.below(kSide)), y = static_cast<int>(rng.below(kSide));
  out.world.start = {x + 0.5, y + 0.5, 0.0};
  flood(out, x, y);
  return out;
}

World moved(const World& world, const Pose2& T) {
  World out = world;
  for (auto* loops : {&out.walls, &out.obstacles}) {
    for (Polygon& loop : *loops) {
      for (Eigen::Vector2d& p : loop) p = T * p;
    }
  }
  out.start = T * world.start;
  return out;
}

TEST(FreeSpace, AgreesWithAFloodOfSquaresHoweverTheWorldIsTurned) {
  int both_kinds = 0;
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    const LatticeCase lattice = lattice_case(seed);
    int reached = 0;
    for (const double angle : {0.0, 0.3, 0.7853981633974483, -1.1, 3.0}) {
      const Pose2 T{0.1, -3.7, angle};
      const FreeSpace free_space(moved(lattice.world, T));
      ASSERT_TRUE(free_space.is_closed()) << "seed " << seed << ", turned by " << angle;
      for (std::size_t y = 0; y < kSide; ++y) {
        for (std::size_t x = 0; x < kSide; ++x) {
          const Eigen::Vector2d p{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
          ASSERT_EQ(free_space.contains(T * p), lattice.reached[y][x])
              << "seed " << seed << ", turned by " << angle << ", square " << x << ", " << y;
          reached += lattice.reached[y][x];
        }
      }
    }
    both_kinds += reached > 50 && reached < 5 * kSide * kSide - 50;
  }
  EXPECT_GT(both_kinds, 75);
}

}  // namespace
}  // namespace cogslam
