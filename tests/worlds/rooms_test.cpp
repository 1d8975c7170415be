#include "worlds/rooms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.hpp"
#include "tests/support/error_text.hpp"
#include "worlds/clearance.hpp"
#include "worlds/free_space.hpp"
#include "worlds/polygon.hpp"
#include "worlds/room_outline.hpp"
#include "worlds/scattered_boxes.hpp"

namespace cogslam {
namespace {

/// Distance of a coordinate to the nearest border of cells of this size [m].
double off_border(double coordinate, double cell_size) {
  return std::abs(coordinate - cell_size * std::round(coordinate / cell_size));
}

/// The least such distance over all walls that run along an axis.
double walls_off_borders(const World& world, double cell_size) {
  double least = cell_size;
  for (const Segment& wall : edges(world.walls.front())) {
    for (int axis = 0; axis < 2; ++axis) {
      if (std::abs(wall.a[axis] - wall.b[axis]) < 1e-9) least = std::min(least, off_border(wall.a[axis], cell_size));
    }
  }
  return least;
}

int oblique_walls(const World& world) {
  int count = 0;
  for (const Segment& wall : edges(world.walls.front())) {
    count += std::abs(wall.a.x() - wall.b.x()) > 1e-9 && std::abs(wall.a.y() - wall.b.y()) > 1e-9;
  }
  return count;
}

bool same(const World& a, const World& b) {
  return a.walls == b.walls && a.obstacles == b.obstacles && a.start == b.start;
}

void expect_drivable(const World& world, const std::string& name) {
  for (const Polygon& loop : world.walls) EXPECT_EQ(defect(loop), std::nullopt) << name;
  EXPECT_GT(signed_area(world.walls.front()), 0.0) << name;
  ASSERT_TRUE(FreeSpace(world).is_closed()) << name;
  const Reach found = reach(world, kRobotRadius, 0.04);
  EXPECT_GE(found.reachable_area, kReachableShare * found.standing_area) << name;
  EXPECT_GT(found.standing_area, 0.4 * found.free_area) << name;
  EXPECT_GT(clearance(world, world.start.position()), 0.4) << name;
}

std::string message_of(const RoomSize& size, std::uint32_t variant) {
  return error_text([&] { cluttered_room(size, variant); });
}

TEST(Rooms, SimpleIsTheRoomOfThePaper) {
  const World world = simple_room();
  ASSERT_EQ(world.walls.size(), 1u);
  EXPECT_EQ(world.walls.front().size(), 4u);
  EXPECT_DOUBLE_EQ(world.bounds().max.x(), 1.524);
  EXPECT_DOUBLE_EQ(world.bounds().min.y(), -1.8288);
  EXPECT_TRUE(world.obstacles.empty());
}

TEST(Rooms, SimpleTakesAnySize) {
  const Rectangle area = simple_room({20.0, 7.5}).bounds();
  EXPECT_EQ(area.min, Eigen::Vector2d(-10.0, -3.75));
  EXPECT_EQ(area.max, Eigen::Vector2d(10.0, 3.75));
}

TEST(Rooms, WallsKeepOffTheCellBorders) {
  for (const double cell_size : {0.1, 0.2, 0.5, 1.0}) {
    EXPECT_GE(walls_off_borders(simple_room(), cell_size), 0.0239);
    EXPECT_GE(walls_off_borders(cornered_room(), cell_size), 0.0399);
    EXPECT_GE(walls_off_borders(cluttered_room(), cell_size), 0.0399);
    for (std::uint32_t variant = 1; variant <= 20; ++variant) {
      EXPECT_GE(walls_off_borders(simple_room(kSimpleSize, variant), cell_size), 0.0399) << variant;
      EXPECT_GE(walls_off_borders(cornered_room(kCorneredSize, variant), cell_size), 0.0399) << variant;
    }
  }
  EXPECT_GE(walls_off_borders(simple_room(), 0.05), 0.0211);
  EXPECT_GE(walls_off_borders(cornered_room(), 0.05), 0.0099);
}

TEST(Rooms, CorneredHasStepsAndObliqueWalls) {
  const World world = cornered_room();
  EXPECT_EQ(world.walls.front().size(), 3u + 2u + 5u + 2u + 4u * 4u);
  EXPECT_EQ(oblique_walls(world), 4);
  for (const Segment& wall : edges(world.walls.front())) EXPECT_GE((wall.b - wall.a).norm(), 0.2999);
  EXPECT_EQ(cluttered_room().walls, world.walls);
}

TEST(Rooms, CorneredFeaturesStayWithinTheirSizes) {
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    Rng rng({.seed = seed, .purpose = Purpose::kWorld});
    const RoomOutline outline = drawn_outline(5.08, 6.08, rng);
    for (const CornerFeature& c : outline.corners) {
      EXPECT_NE(c.kind, CornerFeature::Kind::kPlain);
      EXPECT_TRUE(c.before >= 0.3 - 1e-9 && c.before <= 0.6 + 1e-9 && c.after >= 0.3 - 1e-9 && c.after <= 0.6 + 1e-9);
    }
    for (const WallFeature& w : outline.walls) {
      EXPECT_TRUE(w.width >= 0.3 - 1e-9 && w.width <= 0.6 + 1e-9 && w.depth >= 0.3 - 1e-9 && w.depth <= 0.6 + 1e-9);
    }
    EXPECT_EQ(defect(outline.loop()), std::nullopt);
  }
}

TEST(Rooms, CornersFitTheSmallestRoom) {
  expect_drivable(cornered_room({kSmallestCornered, kSmallestCornered}), "shipped");
  for (std::uint32_t variant = 1; variant <= 20; ++variant) {
    expect_drivable(cornered_room({kSmallestCornered, kSmallestCornered}, variant), std::to_string(variant));
  }
}

TEST(Rooms, BoxesLeaveLanesForTheRobot) {
  for (std::uint32_t variant = 0; variant <= 25; ++variant) {
    const World world = cluttered_room(kCorneredSize, variant);
    EXPECT_GE(world.obstacles.size(), 5u);
    EXPECT_LE(world.obstacles.size(), 8u);
    for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
      const Polygon& box = world.obstacles[i];
      ASSERT_EQ(box.size(), 4u);
      for (const Segment& side : edges(box)) {
        EXPECT_GE((side.b - side.a).norm(), 0.2 - 1e-9);
        EXPECT_LE((side.b - side.a).norm(), 0.8 + 1e-9);
      }
      EXPECT_TRUE(inside(world.walls.front(), box.front()));
      EXPECT_GE(gap(box, world.walls.front()), kLane);
      for (std::size_t j = 0; j < i; ++j) EXPECT_GE(gap(box, world.obstacles[j]), kLane);
    }
  }
}

TEST(Rooms, AShippedRoomOfAnotherSizeKeepsItsLanesOrIsRefused) {
  int made = 0, refused = 0;
  for (double side = 3.5; side <= 7.0; side += 0.25) {
    if (message_of({side, side}, 0) != "no error") {
      ++refused;
      continue;
    }
    ++made;
    const World world = cluttered_room({side, side});
    for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
      EXPECT_GE(gap(world.obstacles[i], world.walls.front()), kLane) << side;
      for (std::size_t j = 0; j < i; ++j) EXPECT_GE(gap(world.obstacles[i], world.obstacles[j]), kLane) << side;
    }
  }
  EXPECT_GT(made, 3);
  EXPECT_GT(refused, 3);
}

TEST(Rooms, EveryVariantCanBeDriven) {
  for (std::uint32_t variant = 0; variant <= 25; ++variant) {
    expect_drivable(simple_room(kSimpleSize, variant), "simple " + std::to_string(variant));
    expect_drivable(cornered_room(kCorneredSize, variant), "cornered " + std::to_string(variant));
    expect_drivable(cluttered_room(kCorneredSize, variant), "cluttered " + std::to_string(variant));
  }
}

TEST(Rooms, AVariantIsAlwaysTheSameAndNeverAnother) {
  for (std::uint32_t variant = 1; variant <= 10; ++variant) {
    EXPECT_TRUE(same(cluttered_room(kCorneredSize, variant), cluttered_room(kCorneredSize, variant)));
    EXPECT_FALSE(same(cluttered_room(kCorneredSize, variant), cluttered_room(kCorneredSize, variant + 1)));
    EXPECT_FALSE(same(cornered_room(kCorneredSize, variant), cornered_room(kCorneredSize, variant + 1)));
    EXPECT_FALSE(same(simple_room(kSimpleSize, variant), simple_room(kSimpleSize, variant + 1)));
  }
}

TEST(Rooms, LargeRoomsAreMade) {
  EXPECT_TRUE(FreeSpace(cornered_room({kLargestRoom, 60.0})).is_closed());
  EXPECT_TRUE(FreeSpace(cluttered_room({20.0, kLargestRoom}, 7)).is_closed());
}

TEST(Rooms, SayWhenTheBoxesDoNotFit) {
  EXPECT_EQ(message_of({3.0, 3.0}, 0),
            "the room is too small for what stands in it, expected a larger width or length");
  EXPECT_EQ(
      message_of({3.0, 3.0}, 5),
      "variant 5: none of 50 drawn rooms leaves the robot a way round, expected a larger room or another variant");
}

TEST(Rooms, ExpectASizeWithinTheirBounds) {
  EXPECT_THROW(simple_room({0.5, 3.0}), ContractViolation);
  EXPECT_THROW(cornered_room({2.9, 5.0}), ContractViolation);
  EXPECT_THROW(cluttered_room({5.0, 201.0}), ContractViolation);
}

TEST(Rooms, OffBordersMovesByHalfACellAtMost) {
  for (int i = -500; i <= 500; ++i) {
    const double v = 0.0137 * i;
    EXPECT_LE(std::abs(off_borders(v) - v), 0.05 + 1e-9);
    EXPECT_GE(off_border(off_borders(v), 0.1), 0.04 - 1e-9);
  }
}

}  // namespace
}  // namespace cogslam
