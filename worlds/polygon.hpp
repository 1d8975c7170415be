#pragma once

#include <optional>
#include <string>

#include "worlds/world.hpp"

namespace cogslam {

/// Twice the area that a -> b -> c encloses [m^2]: positive for a left turn, negative for a right turn.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// The edges of a loop, the closing one last.
std::vector<Segment> edges(const Polygon& loop);

/// Area enclosed [m^2], positive where the corners run counter-clockwise.
double signed_area(const Polygon& loop);

/// Even-odd rule. A point on the loop itself counts to either side.
bool inside(const Polygon& loop, const Eigen::Vector2d& p);

/// Distance from `p` to the nearest point of the segment [m].
double distance(const Segment& s, const Eigen::Vector2d& p);

/// Whether the two share a point; touching counts.
bool touch(const Segment& s, const Segment& t);

/// Smallest distance between two segments [m]; 0 where they touch.
double distance(const Segment& s, const Segment& t);

/// Corners, counter-clockwise, of a rectangle `width` x `length` [m] about the position of `T_map_box`, its width along
/// the box's own x axis.
Polygon box(const Pose2& T_map_box, double width, double length);

/// What keeps a loop from bounding a piece of floor (too few corners, no area, it crosses itself), or nothing.
std::optional<std::string> defect(const Polygon& loop);

}  // namespace cogslam
