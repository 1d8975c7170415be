#include "worlds/hallway.hpp"

#include <span>

namespace cogslam {
namespace {

/// What a wall has on its right-hand side, seen along the wall: a room with a door, or without `depth` a niche or (with
/// a negative `sill`) a pilaster.
struct Recess {
  double door_from, door_to;  ///< along the wall [m]
  double sill;                ///< thickness of the wall, depth of a niche [m]
  double room_from = 0.0, room_to = 0.0;
  double depth = 0.0;  ///< of wall and room [m]; 0: no room
};

constexpr double kFarWall = 6.0;  // from a corridor to the edge of the building [m]

/// Appends the corners of the wall from `a` to just before `b`.
void add_wall(Polygon& loop, const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::span<const Recess> recesses) {
  const Eigen::Vector2d along = (b - a).normalized(), right(along.y(), -along.x());
  const auto corner = [&](double s, double t) { loop.emplace_back(a + s * along + t * right); };
  corner(0.0, 0.0);
  for (const Recess& r : recesses) {
    corner(r.door_from, 0.0);
    corner(r.door_from, r.sill);
    if (r.depth > 0.0) {
      corner(r.room_from, r.sill);
      corner(r.room_from, r.depth);
      corner(r.room_to, r.depth);
      corner(r.room_to, r.sill);
    }
    corner(r.door_to, r.sill);
    corner(r.door_to, 0.0);
  }
}

// Along each wall, in the order in which its loop runs. Doors stand where people put them: not at equal distances.
constexpr Recess kSouth[] = {{1.2, 2.1, 0.2, 0.0, 5.3, kFarWall},     {7.0, 8.0, 0.15},
                             {10.4, 11.4, 0.2, 9.0, 15.1, 4.6},       {17.3, 18.3, 0.15},
                             {19.6, 21.5, 0.2, 19.0, 26.2, kFarWall}, {28.3, 28.8, -0.2},
                             {31.0, 32.0, 0.2, 29.5, 34.4, 3.9},      {36.2, 37.2, 0.15},
                             {40.1, 41.0, 0.2, 38.2, 42.6, 5.1},      {44.2, 45.2, 0.2, 43.4, 50.0, kFarWall}};
constexpr Recess kEast[] = {{3.1, 4.1, 0.15},
                            {6.4, 7.3, 0.2, 5.0, 10.7, kFarWall},
                            {12.6, 13.1, -0.2},
                            {15.2, 16.2, 0.15},
                            {19.9, 20.8, 0.2, 17.9, 23.3, 4.2}};
constexpr Recess kNorth[] = {{2.3, 3.3, 0.15},
                             {5.1, 6.0, 0.2, 4.2, 9.9, kFarWall},
                             {11.8, 12.8, 0.15},
                             {14.4, 14.9, -0.2},
                             {17.2, 18.1, 0.2, 15.8, 21.0, 4.4},
                             {23.6, 24.6, 0.15},
                             {26.7, 28.5, 0.2, 25.5, 32.6, kFarWall},
                             {34.9, 35.9, 0.15},
                             {38.2, 39.1, 0.2, 37.0, 43.5, 5.5},
                             {45.6, 46.6, 0.15}};
constexpr Recess kWest[] = {{2.6, 3.5, 0.2, 1.4, 6.7, 5.2},
                            {8.4, 9.4, 0.15},
                            {11.3, 11.8, -0.2},
                            {14.7, 15.6, 0.2, 12.9, 19.0, kFarWall},
                            {21.5, 22.5, 0.15}};
// Of the two blocks inside the ring: their walls run clockwise.
constexpr Recess kLeftWest[] = {{4.2, 5.2, 0.15}, {9.8, 10.7, 0.2, 8.3, 13.1, 4.0}, {16.9, 17.9, 0.15}};
constexpr Recess kLeftNorth[] = {{3.4, 4.3, 0.2, 1.9, 7.2, 5.0}, {9.6, 10.6, 0.15}, {14.8, 15.7, 0.2, 12.6, 18.5, 4.3}};
constexpr Recess kLeftSouth[] = {{3.7, 4.6, 0.2, 2.2, 8.1, 5.4}, {11.9, 12.9, 0.15}, {16.3, 17.3, 0.15}};
constexpr Recess kRightNorth[] = {{2.7, 3.7, 0.15}, {8.2, 9.1, 0.2, 6.1, 11.8, 4.7}, {15.3, 16.3, 0.15}};
constexpr Recess kRightEast[] = {
    {2.9, 3.8, 0.2, 1.7, 6.6, 4.4}, {10.9, 11.9, 0.15}, {15.8, 16.7, 0.2, 14.1, 19.2, 3.8}};
constexpr Recess kRightSouth[] = {{4.9, 5.9, 0.15}, {10.2, 11.1, 0.2, 8.8, 14.2, 5.2}, {17.6, 18.6, 0.15}};

constexpr double kLeft = 6.1, kRight = 56.15, kLower = 6.1, kUpper = 32.4;  // outer walls of the ring [m]
constexpr double kWide = 2.4;                                               // a corridor [m]
constexpr double kMiddle = 31.1;                                            // the plain corridor runs along this x

Polygon ring() {
  Polygon loop;
  add_wall(loop, {kLeft, kLower}, {kRight, kLower}, kSouth);
  add_wall(loop, {kRight, kLower}, {kRight, kUpper}, kEast);
  add_wall(loop, {kRight, kUpper}, {kLeft, kUpper}, kNorth);
  add_wall(loop, {kLeft, kUpper}, {kLeft, kLower}, kWest);
  return loop;
}

Polygon block(double left, double right, std::span<const Recess> west, std::span<const Recess> north,
              std::span<const Recess> east, std::span<const Recess> south) {
  const double low = kLower + kWide, high = kUpper - kWide;
  Polygon loop;
  add_wall(loop, {left, low}, {left, high}, west);
  add_wall(loop, {left, high}, {right, high}, north);
  add_wall(loop, {right, high}, {right, low}, east);
  add_wall(loop, {right, low}, {left, low}, south);
  return loop;
}

}  // namespace

World hallway() {
  World world;
  world.walls = {ring(), block(kLeft + kWide, kMiddle - 0.5 * kWide, kLeftWest, kLeftNorth, {}, kLeftSouth),
                 block(kMiddle + 0.5 * kWide, kRight - kWide, {}, kRightNorth, kRightEast, kRightSouth)};
  const std::vector<Eigen::Vector2d> route = hallway_route();
  world.start = {route.front().x(), route.front().y(), 0.0};
  return world;
}

std::vector<Eigen::Vector2d> hallway_route() {
  const double half = 0.5 * kWide, left = kLeft + half, right = kRight - half, low = kLower + half, up = kUpper - half;
  return {{left, low}, {right, low}, {right, up}, {left, up}, {left, low}, {kMiddle, low}, {kMiddle, up}};
}

}  // namespace cogslam
