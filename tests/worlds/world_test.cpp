#include "worlds/world.hpp"

#include <gtest/gtest.h>

#include "core/check.hpp"

namespace cogslam {
namespace {

TEST(World, ListsWallsBeforeObstaclesInTheOrderOfTheirCorners) {
  const World world{.walls = {{{0, 0}, {4, 0}, {4, 3}}}, .obstacles = {{{2, 1}, {3, 1}, {3, 2}}}};
  const std::vector<Segment> segments = world.segments();
  ASSERT_EQ(segments.size(), 6u);
  EXPECT_EQ(segments[0].a, Eigen::Vector2d(0, 0));
  EXPECT_EQ(segments[0].b, Eigen::Vector2d(4, 0));
  EXPECT_EQ(segments[2].b, Eigen::Vector2d(0, 0)) << "the last corner joins the first";
  EXPECT_EQ(segments[3].a, Eigen::Vector2d(2, 1));
}

TEST(World, BoundsHoldEverySurface) {
  const World world{.walls = {{{0, 0}, {4, 0}, {4, 3}}}, .obstacles = {{{-2, 1}, {3, 1}, {3, 7}}}};
  EXPECT_EQ(world.bounds().min, Eigen::Vector2d(-2, 0));
  EXPECT_EQ(world.bounds().max, Eigen::Vector2d(4, 7));
}

TEST(World, WithoutSurfacesHasNoBounds) { EXPECT_THROW(World{}.bounds(), ContractViolation); }

}  // namespace
}  // namespace cogslam
