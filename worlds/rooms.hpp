#pragma once

#include <cstdint>

#include "worlds/world.hpp"

namespace cogslam {

/// How large a room is, and which one of its kind.
struct RoomSize {
  double width = 0.0;   ///< along x [m]
  double length = 0.0;  ///< along y [m]
};

constexpr RoomSize kSimpleSize{3.048, 3.6576};  ///< 10 x 12 ft, the room of the paper
constexpr RoomSize kCorneredSize{5.08, 6.08};
constexpr double kSmallestSimple = 1.0;    ///< both ways [m]
constexpr double kSmallestCornered = 3.0;  ///< both ways [m]
constexpr double kLargestRoom = 200.0;     ///< both ways [m]

/// Rooms of one kind. All are centred on the origin, which is free; the plain floor of a World lies in them.
///
/// `variant` 0 is the shipped room of the kind, the same on every machine. Any other number draws a room: its sides
/// within 20 % of `size`, its corners, walls and boxes from the stream of that number. A drawn room, and a shipped one
/// of another size, is checked with a round robot of kRobotRadius: it must be able to drive from the start to at least
/// kReachableShare of the floor on which it can stand, and every lane must be kLane wide. Drawn rooms are drawn again
/// up to kDraws times; then, and where a shipped room does not fit, InputError says so.
constexpr double kRobotRadius = 0.3;      ///< [m]
constexpr double kReachableShare = 0.99;  ///< of the standing area of clearance.hpp
constexpr double kLane = 0.7;             ///< between a box and any other surface [m]
constexpr std::uint32_t kDraws = 50;

/// A rectangle. In the default size the walls lie at x = +-1.524 m and y = +-1.8288 m: 0.024 m and 0.0288 m off the
/// nearest border of 0.1 m cells and of 0.05 m cells, further off the borders of larger ones.
World simple_room(const RoomSize& size = kSimpleSize, std::uint32_t variant = 0);

/// A rectangle whose corners and walls have steps, oblique cuts, alcoves, bays and pilasters of 0.3 m to 0.6 m. In the
/// default size all corners lie 0.04 m off the borders of 0.1 m cells (0.01 m off those of 0.05 m cells).
World cornered_room(const RoomSize& size = kCorneredSize, std::uint32_t variant = 0);

/// The cornered room with 5 to 8 boxes of 0.2 m to 0.8 m side about the floor, turned at any angle.
World cluttered_room(const RoomSize& size = kCorneredSize, std::uint32_t variant = 0);

}  // namespace cogslam
