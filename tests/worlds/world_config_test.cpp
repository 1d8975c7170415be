#include "worlds/world_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "tests/support/error_text.hpp"
#include "worlds/hallway.hpp"
#include "worlds/polygon.hpp"
#include "worlds/rooms.hpp"

namespace cogslam {
namespace {

World world_of(const std::string& text) {
  ConfigSection section = ConfigSection::parse(text, "w.yaml");
  World world = read_world(section);
  section.finish();
  return world;
}

std::string message_of(const std::string& text) {
  return error_text([&text] { world_of(text); });
}

/// A square room of 4 m with whatever follows.
std::string square_with(const std::string& more) {
  return "kind: polygons\nwalls: [{corners_m: [[-2, -2], [2, -2], [2, 2], [-2, 2]]}]\n" + more;
}

TEST(WorldConfig, WithoutKeysIsTheSimpleRoom) {
  const World world = world_of("{}");
  EXPECT_EQ(world.walls, simple_room().walls);
  EXPECT_EQ(world.start, Pose2{});
  EXPECT_EQ(world.floor.kind, FloorKind::kCarpet);
}

TEST(WorldConfig, BuildsEveryKindOfRoom) {
  EXPECT_EQ(world_of("{kind: cornered, variant: 3}").walls, cornered_room(kCorneredSize, 3).walls);
  EXPECT_EQ(world_of("{kind: cluttered}").obstacles, cluttered_room().obstacles);
  EXPECT_EQ(world_of("{kind: cluttered}").start, cluttered_room().start);
  EXPECT_EQ(world_of("{kind: simple, width_m: 7, length_m: 9}").walls, simple_room({7, 9}).walls);
}

TEST(WorldConfig, BuildsTheHallwayWhichHasOneSizeOnly) {
  EXPECT_EQ(world_of("{kind: hallway}").walls, hallway().walls);
  EXPECT_EQ(world_of("{kind: hallway}").start, hallway().start);
  EXPECT_THAT(message_of("{kind: hallway, width_m: 7}"), testing::HasSubstr("width_m"));
}

TEST(WorldConfig, ReadsPolygonsBoxesStartFloorAndPatches) {
  const World world =
      world_of(square_with("obstacles:\n"
                           "  - corners_m: [[1, 1], [1.5, 1], [1.2, 1.6]]\n"
                           "  - box: {x_m: -1, y_m: 0.5, heading_deg: 90, width_m: 0.4, length_m: 0.6}\n"
                           "start: {x_m: 0.5, y_m: -1, heading_deg: 270}\n"
                           "floor: {kind: tile, contrast: 0.4, seed: 9}\n"
                           "slip_patches: [{x_m: 1, y_m: -1, radius_m: 0.3, friction: 0.1}]\n"));
  ASSERT_EQ(world.obstacles.size(), 2u);
  EXPECT_EQ(world.obstacles[0][2], Eigen::Vector2d(1.2, 1.6));
  EXPECT_EQ(world.obstacles[1], box({-1, 0.5, std::numbers::pi / 2}, 0.4, 0.6));
  EXPECT_NEAR(world.start.theta, -std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(world.start.position(), Eigen::Vector2d(0.5, -1));
  EXPECT_EQ(world.floor.kind, FloorKind::kTile);
  EXPECT_EQ(world.floor.contrast, 0.4);
  EXPECT_EQ(world.floor.seed, 9u);
  ASSERT_EQ(world.slip_patches.size(), 1u);
  EXPECT_EQ(world.slip_patches[0].centre, Eigen::Vector2d(1, -1));
  EXPECT_EQ(world.slip_patches[0].friction, 0.1);
}

TEST(WorldConfig, ItsResolvedTextGivesTheSameWorld) {
  for (const std::string text : {"{kind: cluttered, variant: 2}", "{kind: simple, start: {x_m: 0.3}}"}) {
    ConfigSection section = ConfigSection::parse(text, "w.yaml");
    const World first = read_world(section), second = world_of(section.resolved());
    EXPECT_EQ(first.walls, second.walls);
    EXPECT_EQ(first.obstacles, second.obstacles);
    EXPECT_EQ(first.start, second.start);
  }
}

TEST(WorldConfig, RejectsLoopsThatBoundNothing) {
  EXPECT_EQ(message_of("kind: polygons\nwalls:\n  - corners_m: [[0, 0], [1, 0]]\n"),
            "w.yaml:3:5: the loop has 2 corners, expected at least 3");
  EXPECT_EQ(message_of("kind: polygons\nwalls:\n  - corners_m: [[0, 0], [2, 2], [2, 0], [0, 2]]\n"),
            "w.yaml:3:5: the loop crosses itself: the edges from corner 1 and from corner 3 meet");
  EXPECT_EQ(message_of(square_with("obstacles: [{corners_m: [[1, 1], [1.0001, 1], [1, 1.0001]]}]\n")),
            "w.yaml:3:14: the loop has no area");
}

TEST(WorldConfig, RejectsAStartThatIsNotFree) {
  EXPECT_EQ(message_of(square_with("start: {x_m: 3}\n")),
            "w.yaml:3:1: the walls do not close around the start, expected a start inside the room");
  EXPECT_EQ(message_of(square_with("start: {x_m: 1}\nobstacles: [{box: {x_m: 1}}]\n")),
            "w.yaml:3:1: the start lies within an obstacle, expected free floor");
  EXPECT_EQ(message_of(square_with("start: {x_m: 2}\n")),
            "w.yaml:3:1: the start lies on a surface, expected free floor");
  EXPECT_EQ(message_of(square_with("obstacles: [{box: {}}]\n")),
            "w.yaml:1:1: the start lies within an obstacle, expected free floor");
}

TEST(WorldConfig, RejectsAWorldOfMoreThan200Metres) {
  EXPECT_EQ(message_of("kind: polygons\nwalls: [{corners_m: [[-101, -2], [101, -2], [101, 2], [-101, 2]]}]\n"),
            "w.yaml:2:1: the world is larger than 200 m, expected at most 200 m each way");
  EXPECT_NE(message_of("width_m: 201\n").find("w.yaml:1:"), std::string::npos);
}

TEST(WorldConfig, SaysThatTheBoxesDoNotFit) {
  EXPECT_EQ(message_of("kind: cluttered\nwidth_m: 3\nlength_m: 3\n"),
            "w.yaml:2:1: the room is too small for what stands in it, expected a larger width or length");
}

TEST(WorldConfig, RejectsWhatTheKindDoesNotHave) {
  EXPECT_EQ(message_of("kind: polygons\n"), "w.yaml:1:1: polygons without walls, expected at least one loop");
  EXPECT_NE(message_of("kind: simple\nwalls: []\n").find("w.yaml:2:1"), std::string::npos);
  EXPECT_NE(message_of(square_with("variant: 2\n")).find("w.yaml:3:1"), std::string::npos);
  EXPECT_EQ(message_of(square_with("obstacles: [{box: {}, corners_m: []}]\n")),
            "w.yaml:3:14: an obstacle is a box or a loop, not both");
}

}  // namespace
}  // namespace cogslam
