#include "worlds/world_config.hpp"

#include "worlds/clearance.hpp"
#include "worlds/free_space.hpp"
#include "worlds/hallway.hpp"
#include "worlds/map_config.hpp"
#include "worlds/polygon.hpp"
#include "worlds/rooms.hpp"
#include "worlds/world_faults.hpp"

namespace cogslam {
namespace {

enum class WorldKind { kSimple, kCornered, kCluttered, kHallway, kPolygons, kMap };

/// Where anything may stand [m].
constexpr Range kAnywhere{-1e4, 1e4};
constexpr std::size_t kMostCorners = 10000;   // of a loop
constexpr std::size_t kMostSurfaces = 20000;  // of the world

/// A start nearer to a surface than this [m] is on it.
constexpr double kOnSurface = 1e-6;

Polygon read_corners(ConfigSection& section) {
  Polygon corners;
  section.read("corners_m", corners, kAnywhere);
  if (corners.size() > kMostCorners) section.fail("corners_m", "the loop has too many corners, expected at most 10000");
  if (const auto wrong = defect(corners)) section.fail("corners_m", "the loop " + *wrong);
  return corners;
}

Polygon read_box(ConfigSection section) {
  Pose2 T_map_box;
  double width = 0.5, length = 0.5;
  section.read("x_m", T_map_box.x, kAnywhere);
  section.read("y_m", T_map_box.y, kAnywhere);
  section.read_degrees("heading_deg", T_map_box.theta);
  section.read("width_m", width, {0.01, kLargestRoom});
  section.read("length_m", length, {0.01, kLargestRoom});
  return box(T_map_box, width, length);
}

World read_room(ConfigSection& section, WorldKind kind) {
  RoomSize size = kind == WorldKind::kSimple ? kSimpleSize : kCorneredSize;
  const Range range{kind == WorldKind::kSimple ? kSmallestSimple : kSmallestCornered, kLargestRoom};
  std::uint32_t variant = 0;
  section.read("width_m", size.width, range);
  section.read("length_m", size.length, range);
  section.read("variant", variant);
  try {
    switch (kind) {
      case WorldKind::kSimple:
        return simple_room(size, variant);
      case WorldKind::kCornered:
        return cornered_room(size, variant);
      default:
        return cluttered_room(size, variant);
    }
  } catch (const InputError& error) {
    section.fail(variant == 0 ? "width_m" : "variant", error.what());
  }
}

World read_polygons(ConfigSection& section) {
  World world;
  for (ConfigSection& wall : section.sections("walls")) world.walls.push_back(read_corners(wall));
  if (world.walls.empty()) section.fail("walls", "polygons without walls, expected at least one loop");
  return world;
}

/// Walls, and the obstacles and the start that belong to a room.
World read_walls(ConfigSection& section, WorldKind kind) {
  if (kind == WorldKind::kHallway) return hallway();
  if (kind == WorldKind::kMap) return read_map_world(section);
  return kind == WorldKind::kPolygons ? read_polygons(section) : read_room(section, kind);
}

void read_obstacles(ConfigSection& section, World& world) {
  for (ConfigSection& obstacle : section.sections("obstacles")) {
    const bool is_box = obstacle.has("box");
    if (is_box && obstacle.has("corners_m")) obstacle.fail("box", "an obstacle is a box or a loop, not both");
    world.obstacles.push_back(is_box ? read_box(obstacle.section("box")) : read_corners(obstacle));
  }
}

void read_floor(ConfigSection section, Floor& floor) {
  section.read_choice("kind", floor.kind,
                      {{"carpet", FloorKind::kCarpet},
                       {"wood", FloorKind::kWood},
                       {"concrete", FloorKind::kConcrete},
                       {"tile", FloorKind::kTile},
                       {"plain", FloorKind::kPlain}});
  section.read("contrast", floor.contrast, {0.0, 1.0});
  section.read("seed", floor.seed);
}

void read_start(ConfigSection section, Pose2& start) {
  section.read("x_m", start.x, kAnywhere);
  section.read("y_m", start.y, kAnywhere);
  section.read_degrees("heading_deg", start.theta);
  start.theta = wrap_angle(start.theta);
}

FreeSpace free_space(const ConfigSection& section, const World& world) {
  try {
    return FreeSpace(world);
  } catch (const InputError& error) {
    section.fail(world.map ? "map" : section.has("obstacles") ? "obstacles" : "walls", error.what());
  }
}

void check_world(const ConfigSection& section, const World& world) {
  const std::size_t most = kMostSurfaces + (world.map ? kMostMapSurfaces : 0);
  if (world.segments().size() > most) {
    section.fail(section.has("obstacles") ? "obstacles" : "walls",
                 "too many surfaces in the world, expected at most " + std::to_string(most));
  }
  const Rectangle area = world.bounds();
  const Eigen::Vector2d extent = area.max - area.min;
  if (extent.maxCoeff() > kLargestRoom) {
    const char* walls = world.map ? "map" : "walls";
    const char* cause = section.has("obstacles") && !section.has(walls) ? "obstacles" : walls;
    section.fail(cause, "the world is larger than 200 m, expected at most 200 m each way");
  }
  const Eigen::Vector2d start = world.start.position();
  if (clearance(world, start) < kOnSurface) section.fail("start", "the start lies on a surface, expected free floor");
  if (world.map) check_map_start(section, world);
  for (const Polygon& obstacle : world.obstacles) {
    if (inside(obstacle, start)) section.fail("start", "the start lies within an obstacle, expected free floor");
  }
  if (!free_space(section, world).is_closed()) {
    section.fail("start", world.map ? "the map's walls do not close around the start, expected a start inside them, or "
                                      "`unknown: solid`, which closes them"
                                    : "the walls do not close around the start, expected a start inside the room");
  }
}

}  // namespace

World read_world(ConfigSection& section) {
  WorldKind kind = WorldKind::kSimple;
  section.read_choice("kind", kind,
                      {{"simple", WorldKind::kSimple},
                       {"cornered", WorldKind::kCornered},
                       {"cluttered", WorldKind::kCluttered},
                       {"hallway", WorldKind::kHallway},
                       {"polygons", WorldKind::kPolygons},
                       {"map", WorldKind::kMap}});
  World world = read_walls(section, kind);
  read_obstacles(section, world);
  read_start(section.section("start"), world.start);
  read_floor(section.section("floor"), world.floor);
  for (ConfigSection& patch : section.sections("slip_patches")) world.slip_patches.push_back(read_slip_patch(patch));
  check_world(section, world);
  return world;
}

}  // namespace cogslam
