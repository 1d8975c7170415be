#include "worlds/clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cogslam {
namespace {

/// A 4 m x 4 m room; a wall across it leaves a lane of `lane` at the bottom.
World two_rooms(double lane) {
  return {.walls = {{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}},
          .obstacles = {{{-0.05, -2 + lane}, {0.05, -2 + lane}, {0.05, 2}, {-0.05, 2}}},
          .start = {-1, 0, 0}};
}

TEST(Clearance, IsTheDistanceToTheNearestSurface) {
  EXPECT_NEAR(clearance(two_rooms(1.0), {-1.5, 0.0}), 0.5, 1e-12);
  EXPECT_NEAR(clearance(two_rooms(1.0), {-0.35, -1.4}), std::hypot(0.3, 0.4), 1e-12);
}

TEST(Clearance, OfAWayIsZeroThroughAWall) {
  EXPECT_EQ(clearance(two_rooms(1.0), Segment{{-1, 0}, {1, 0}}), 0.0);
  EXPECT_NEAR(clearance(two_rooms(1.0), Segment{{-1, -1.6}, {1, -1.6}}), 0.4, 1e-12);
}

TEST(Reach, EndsAtALaneTooNarrowForTheRobot) {
  const Reach wide = reach(two_rooms(0.75), 0.3), narrow = reach(two_rooms(0.5), 0.3);
  EXPECT_NEAR(wide.reachable_area, wide.standing_area, 1e-9);
  EXPECT_NEAR(narrow.reachable_area, 0.5 * narrow.standing_area, 0.02);
  EXPECT_NEAR(wide.free_area, 16.0 - 0.1 * 3.25, 0.2);
  // The standing floor is a square of 3.4 m less a strip of 0.7 m, round at its lower end, 1.5 m above the wall below.
  EXPECT_NEAR(narrow.standing_area, 3.4 * 3.4 - 0.7 * 3.2 + 0.5 * (1.0 - 0.25 * std::numbers::pi) * 0.36, 0.25);
}

TEST(Reach, OfAStartTooNearAWallIsNothing) {
  World world = two_rooms(1.0);
  world.start = {-1.9, 0, 0};
  EXPECT_EQ(reach(world, 0.3).reachable_area, 0.0);
}

}  // namespace
}  // namespace cogslam
