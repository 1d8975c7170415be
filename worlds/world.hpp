#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/grid_frame.hpp"
#include "core/pose2.hpp"

namespace cogslam {

/// A straight piece of surface [m].
struct Segment {
  Eigen::Vector2d a{0.0, 0.0};
  Eigen::Vector2d b{0.0, 0.0};
};

/// Corners of a closed loop [m]; the last joins the first.
using Polygon = std::vector<Eigen::Vector2d>;

enum class FloorKind : std::uint8_t { kCarpet, kWood, kConcrete, kTile, kPlain };

/// What the floor camera looks at.
struct Floor {
  FloorKind kind = FloorKind::kCarpet;
  double contrast = 1.0;   ///< share of the kind's own contrast, in [0, 1]
  std::uint32_t seed = 1;  ///< which piece of carpet
};

/// A disc in which the wheels grip less.
struct SlipPatch {
  Eigen::Vector2d centre{0.0, 0.0};
  double radius = 0.5;    ///< [m]
  double friction = 0.2;  ///< share of the usual friction, in [0, 1]
};

/// A thing of iron, whose field turns the needle of a compass nearby: a magnetic dipole.
struct Magnet {
  Eigen::Vector2d centre{0.0, 0.0};
  double reach = 0.5;  ///< beside it, at this distance, its field is as strong as the earth's [m]
  double axis = 0.0;   ///< direction of its moment, counter-clockwise from the map's +x [rad]
};

struct OccupancyMap;

/// What is there: surfaces and floor, a plain value. Surfaces have no thickness. A point is free where the start can be
/// reached without crossing a surface, so walls need no inside; solid boxes are loops like any other.
struct World {
  std::vector<Polygon> walls;      ///< loops that bound the room, from inside or outside
  std::vector<Polygon> obstacles;  ///< boxes and other loops that stand in it
  Floor floor{};
  std::vector<Segment> panes;  ///< of glass: they stop the vehicle, but no beam; a wall is glass where one lies on it
  std::vector<SlipPatch> slip_patches;
  std::vector<Magnet> magnets;
  Pose2 start{};                            ///< T_map_base at time 0; the map frame is the world frame
  std::shared_ptr<const OccupancyMap> map;  ///< that the surfaces were drawn from, where there was one

  /// Every surface, walls first, in the order of their corners; glass last.
  [[nodiscard]] std::vector<Segment> segments() const;
  /// What light comes back from: neither panes nor the walls that they lie on.
  [[nodiscard]] std::vector<Segment> opaque_segments() const;
  /// The smallest rectangle around all surfaces.
  [[nodiscard]] Rectangle bounds() const;
};

}  // namespace cogslam
