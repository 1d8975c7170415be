#include "worlds/rooms.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "core/check.hpp"
#include "core/error.hpp"
#include "worlds/clearance.hpp"
#include "worlds/polygon.hpp"
#include "worlds/room_outline.hpp"
#include "worlds/scattered_boxes.hpp"

namespace cogslam {
namespace {

constexpr double kVariantSpread = 0.2;

void expect_size(const RoomSize& size, double smallest) {
  EXPECTS(size.width >= smallest && size.length >= smallest);
  EXPECTS(size.width <= kLargestRoom && size.length <= kLargestRoom);
}

double drawn_side(double side, double smallest, Rng& rng) {
  const double drawn = side * rng.uniform(1.0 - kVariantSpread, 1.0 + kVariantSpread);
  return std::clamp(2.0 * off_borders(0.5 * drawn), smallest, kLargestRoom);
}

RoomSize drawn_size(const RoomSize& size, double smallest, Rng& rng) {
  const double width = drawn_side(size.width, smallest, rng);
  return {width, drawn_side(size.length, smallest, rng)};
}

bool lanes_are_wide(const World& world) {
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (!inside(world.walls.front(), world.obstacles[i].front())) return false;
    if (gap(world.obstacles[i], world.walls.front()) < kLane) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (gap(world.obstacles[i], world.obstacles[j]) < kLane) return false;
    }
  }
  return true;
}

bool can_be_driven(const World& world) {
  if (!lanes_are_wide(world)) return false;
  // Large rooms need no fine raster: their lanes have been measured.
  const Rectangle area = world.bounds();
  const Reach found = reach(world, kRobotRadius, std::max(0.05, (area.max - area.min).maxCoeff() / 200.0));
  return found.standing_area > 0.0 && found.reachable_area >= kReachableShare * found.standing_area;
}

/// The first room that can be driven of those that `draw` gives.
World drawn_room(std::uint32_t variant, const std::function<std::optional<World>(Rng&)>& draw) {
  for (std::uint32_t attempt = 0; attempt < kDraws; ++attempt) {
    Rng rng({.seed = variant, .purpose = Purpose::kWorld, .entity = attempt});
    const std::optional<World> world = draw(rng);
    if (world && can_be_driven(*world)) return *world;
  }
  throw InputError("variant " + std::to_string(variant) + ": none of " + std::to_string(kDraws) +
                   " drawn rooms leaves the robot a way round, expected a larger room or another variant");
}

World shipped_room(World world) {
  if (!can_be_driven(world)) {
    throw InputError("the room is too small for what stands in it, expected a larger width or length");
  }
  return world;
}

}  // namespace

World simple_room(const RoomSize& size, std::uint32_t variant) {
  expect_size(size, kSmallestSimple);
  if (variant == 0) return shipped_room({.walls = {RoomOutline{size.width, size.length}.loop()}});
  return drawn_room(variant, [&](Rng& rng) -> std::optional<World> {
    const RoomSize drawn = drawn_size(size, kSmallestSimple, rng);
    return World{.walls = {RoomOutline{drawn.width, drawn.length}.loop()}};
  });
}

World cornered_room(const RoomSize& size, std::uint32_t variant) {
  expect_size(size, kSmallestCornered);
  if (variant == 0) return shipped_room({.walls = {shipped_outline(size.width, size.length).loop()}});
  return drawn_room(variant, [&](Rng& rng) -> std::optional<World> {
    const RoomSize drawn = drawn_size(size, kSmallestCornered, rng);
    return World{.walls = {drawn_outline(drawn.width, drawn.length, rng).loop()}};
  });
}

World cluttered_room(const RoomSize& size, std::uint32_t variant) {
  expect_size(size, kSmallestCornered);
  if (variant == 0) {
    const double scale_x = size.width / kCorneredSize.width, scale_y = size.length / kCorneredSize.length;
    return shipped_room({.walls = {shipped_outline(size.width, size.length).loop()},
                         .obstacles = shipped_boxes(scale_x, scale_y),
                         .start = {0.0, -2.3 * scale_y, 0.0}});
  }
  return drawn_room(variant, [&](Rng& rng) -> std::optional<World> {
    const RoomSize drawn = drawn_size(size, kSmallestCornered, rng);
    const Polygon outline = drawn_outline(drawn.width, drawn.length, rng).loop();
    const auto boxes = drawn_boxes(outline, kLane, rng);
    if (!boxes) return std::nullopt;
    return World{.walls = {outline}, .obstacles = *boxes};
  });
}

}  // namespace cogslam
