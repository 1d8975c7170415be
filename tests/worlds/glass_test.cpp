#include "worlds/glass.hpp"

#include <gtest/gtest.h>

#include "tests/support/test_worlds.hpp"

namespace cogslam {
namespace {

double length_of(const std::vector<Segment>& segments) {
  double sum = 0.0;
  for (const Segment& s : segments) sum += (s.b - s.a).norm();
  return sum;
}

TEST(Glass, TakesOutThePieceOfAWallThatItLiesOn) {
  const std::vector<Segment> wall{{{0.0, 1.0}, {4.0, 1.0}}};
  const std::vector<Segment> left = opaque_parts(wall, {{{3.0, 1.0}, {1.0, 1.0}}});
  ASSERT_EQ(left.size(), 2U);
  EXPECT_LT((left[0].b - Eigen::Vector2d(1.0, 1.0)).norm(), 1e-12);
  EXPECT_LT((left[1].a - Eigen::Vector2d(3.0, 1.0)).norm(), 1e-12);
  EXPECT_EQ(left[0].a, wall[0].a);
  EXPECT_EQ(left[1].b, wall[0].b);
}

TEST(Glass, TakesAWholeWallAndWhatReachesRoundItsCorners) {
  World room = square_room(4.0);
  room.panes = {{{-3.0, -2.0}, {3.0, -2.0}}, {{2.0, 1.0}, {2.0, 5.0}}};
  EXPECT_NEAR(length_of(room.opaque_segments()), 16.0 - 4.0 - 1.0, 1e-9);
  EXPECT_EQ(room.segments().size(), 6U) << "walls and panes all stop the vehicle";
}

TEST(Glass, LeavesWallsThatItCrossesOrRunsBeside) {
  World room = square_room(4.0);
  room.panes = {{{0.0, -3.0}, {0.0, 3.0}}, {{-1.0, 1.9}, {1.0, 1.9}}};
  EXPECT_NEAR(length_of(room.opaque_segments()), 16.0, 1e-12);
}

TEST(Glass, BelongsToTheBoundsOfTheWorldWithBothEnds) {
  World room = square_room(4.0);
  room.panes = {{{0.0, 0.0}, {7.0, -5.0}}};
  EXPECT_EQ(room.bounds().max, Eigen::Vector2d(7.0, 2.0));
  EXPECT_EQ(room.bounds().min, Eigen::Vector2d(-2.0, -5.0));
}

}  // namespace
}  // namespace cogslam
