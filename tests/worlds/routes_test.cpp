#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "worlds/clearance.hpp"
#include "worlds/polygon.hpp"
#include "worlds/rooms.hpp"

namespace cogslam {
namespace {

/// Closed loops round the shipped rooms, the start last [m]. The scenarios drive them.
using Route = std::vector<Eigen::Vector2d>;
const Route kSimpleRoute{{1.0, -1.3}, {1.0, 1.3},  {-1.0, 1.3}, {-1.0, -1.3},
                         {1.0, 1.3},  {-1.0, 1.3}, {1.0, -1.3}, {0.0, -1.3}};
const Route kCorneredRoute{{1.8, -2.2}, {1.8, 2.2}, {-1.8, 2.2}, {-1.8, -0.7}, {-0.6, -1.3}, {-1.8, -2.2}, {0.0, -2.2}};
const Route kClutteredRoute{{1.4, -2.5},  {2.0, -1.6},  {2.03, -0.5},  {1.85, 0.0},  {1.45, 0.22},  {0.5, 0.55},
                            {0.4, 1.2},   {1.05, 2.25}, {-1.2, 2.5},   {-2.0, 1.7},  {-2.05, -0.3}, {-1.9, -1.8},
                            {-1.2, -2.2}, {-0.4, -1.8}, {-0.45, -0.8}, {-0.1, -1.3}, {0.0, -2.3}};

constexpr double kSpeed = 0.3;       // [m/s]
constexpr double kClearance = 0.35;  // [m], from the centre of the robot
constexpr double kPassing = 1.25;    // [m]: every surface is passed at least this closely

void expect_good_route(const World& world, const Route& route) {
  double length = 0.0;
  std::vector<Segment> legs;
  for (std::size_t i = 0; i < route.size(); ++i) legs.push_back({route[i], route[(i + 1) % route.size()]});
  for (const Segment& leg : legs) {
    EXPECT_GE(clearance(world, leg), kClearance) << "leg from " << leg.a.transpose() << " to " << leg.b.transpose();
    length += (leg.b - leg.a).norm();
  }
  EXPECT_NEAR(length / kSpeed, 60.0, 3.0);
  for (const Segment& surface : world.segments()) {
    const bool passed = std::any_of(legs.begin(), legs.end(),
                                    [&surface](const Segment& leg) { return distance(leg, surface) < kPassing; });
    EXPECT_TRUE(passed) << "surface from " << surface.a.transpose() << " to " << surface.b.transpose();
  }
}

TEST(Routes, GoRoundTheSimpleRoom) { expect_good_route(simple_room(), kSimpleRoute); }
TEST(Routes, GoRoundTheCorneredRoom) { expect_good_route(cornered_room(), kCorneredRoute); }
TEST(Routes, GoBetweenTheBoxesOfTheClutteredRoom) {
  expect_good_route(cluttered_room(), kClutteredRoute);
  EXPECT_EQ(cluttered_room().start.position(), kClutteredRoute.back());
}

}  // namespace
}  // namespace cogslam
