#pragma once

#include <array>

#include "core/rng.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// What a corner of a rectangular room looks like.
struct CornerFeature {
  enum class Kind : std::uint8_t { kPlain, kStep, kCut, kStair };
  Kind kind = Kind::kPlain;  ///< square; one step inwards; an oblique cut; two steps inwards
  double before = 0.0;       ///< how far from the corner it begins, along the wall that ends here [m]
  double after = 0.0;        ///< how far from the corner it ends, along the wall that starts here [m]
};

/// What interrupts a wall.
struct WallFeature {
  enum class Kind : std::uint8_t { kPlain, kAlcove, kPilaster, kBay };
  Kind kind = Kind::kPlain;  ///< nothing; a square recess; a square jut inwards; a recess with oblique sides
  double at = 0.5;           ///< where along the wall its middle lies, in (0, 1)
  double width = 0.0;        ///< along the wall [m]
  double depth = 0.0;        ///< across the wall [m]
};

/// A rectangle centred on the origin, with features: corner i is where wall i starts. Walls run counter-clockwise:
/// bottom, right, top, left; corner 0 is the lower left one.
struct RoomOutline {
  double width = 0.0;   ///< along x, alcoves not counted [m]
  double length = 0.0;  ///< along y [m]
  std::array<CornerFeature, 4> corners{};
  std::array<WallFeature, 4> walls{};

  /// The loop of the walls, counter-clockwise.
  [[nodiscard]] Polygon loop() const;
};

/// Moves a coordinate [m] to the nearest value of the form 0.1 n + 0.04: at least 0.04 m off the borders of cells of
/// 0.1, 0.2, 0.5 and 1.0 m, and 0.01 m off those of 0.05 m.
double off_borders(double coordinate);

/// The corners and walls of the shipped room with complex corners, on any rectangle of at least 3 m x 3 m.
RoomOutline shipped_outline(double width, double length);

/// Draws a feature for every corner and wall. Each is 0.3 m to 0.6 m large, in whole 0.1 m.
RoomOutline drawn_outline(double width, double length, Rng& rng);

}  // namespace cogslam
