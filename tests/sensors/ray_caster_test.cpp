#include "sensors/ray_caster.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "sim/simulation.hpp"
#include "tests/support/brute_force_caster.hpp"
#include "tests/support/test_worlds.hpp"

namespace cogslam {
namespace {

using Eigen::Vector2d;

Vector2d unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST(RayCaster, MeasuresTheWallsOfARoom) {
  const RayCaster caster(square_room(4.0));
  EXPECT_DOUBLE_EQ(caster.cast({0.5, 0.0}, {1.0, 0.0}, 30.0).value(), 1.5);
  EXPECT_DOUBLE_EQ(caster.cast({0.5, 0.0}, {-1.0, 0.0}, 30.0).value(), 2.5);
  EXPECT_NEAR(caster.cast({0.0, 0.0}, unit(std::numbers::pi / 4), 30.0).value(), 2.0 * std::numbers::sqrt2, 1e-12);
}

TEST(RayCaster, FindsNothingBeyondItsRangeOrInAnEmptyWorld) {
  const RayCaster caster(square_room(4.0));
  EXPECT_FALSE(caster.cast({0.0, 0.0}, {1.0, 0.0}, 1.999).has_value());
  EXPECT_TRUE(caster.cast({0.0, 0.0}, {1.0, 0.0}, 2.0).has_value());
  EXPECT_FALSE(RayCaster(std::vector<Segment>{}).cast({0.0, 0.0}, {1.0, 0.0}, 30.0).has_value());
}

TEST(RayCaster, SeesSurfacesFromOutsideTheirRectangle) {
  const RayCaster caster(square_room(4.0));
  EXPECT_DOUBLE_EQ(caster.cast({-10.0, 0.3}, {1.0, 0.0}, 30.0).value(), 8.0);
  EXPECT_FALSE(caster.cast({-10.0, 0.3}, {-1.0, 0.0}, 30.0).has_value());
  EXPECT_FALSE(caster.cast({-10.0, 3.0}, {1.0, 0.0}, 30.0).has_value());
}

TEST(RayCaster, SeesASegmentThatLiesAlongTheRay) {
  const RayCaster caster(std::vector<Segment>{{{1.0, 0.0}, {2.0, 0.0}}});
  EXPECT_DOUBLE_EQ(caster.cast({0.0, 0.0}, {1.0, 0.0}, 30.0).value(), 1.0);
  EXPECT_DOUBLE_EQ(caster.cast({3.0, 0.0}, {-1.0, 0.0}, 30.0).value(), 1.0);
  EXPECT_DOUBLE_EQ(caster.cast({1.5, 0.0}, {-1.0, 0.0}, 30.0).value(), 0.0);
  EXPECT_FALSE(caster.cast({3.0, 0.0}, {1.0, 0.0}, 30.0).has_value());
}

TEST(RayCaster, LetsNoRaySlipThroughACorner) {
  // A round wall of 720 pieces: aim at its corners and their closest neighbours.
  World world;
  world.walls.emplace_back();
  for (int i = 0; i < 720; ++i) world.walls[0].push_back(Vector2d(0.3, -0.2) + 3.0 * unit(i * std::numbers::pi / 360));
  const RayCaster caster(world);
  for (const Vector2d& corner : world.walls[0]) {
    const double angle = std::atan2(corner.y(), corner.x());
    for (const double off : {0.0, 1e-16, -1e-16, 1e-15, -1e-15, 1e-12})
      EXPECT_NEAR(caster.cast({0.0, 0.0}, unit(angle + off), 30.0).value_or(-1.0), corner.norm(), 1e-9);
  }
}

TEST(RayCaster, EqualsBruteForceOnRandomWorlds) {
  int hits = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    const World world = room_with_boxes(static_cast<int>(seed * seed), seed);
    const std::vector<Segment> segments = world.segments();
    const RayCaster caster(world);
    Rng rng({seed, Purpose::kWorld, 1, 0});
    for (int i = 0; i < 5000; ++i) {
      const Vector2d origin(rng.uniform(-7.0, 7.0), rng.uniform(-7.0, 7.0));
      const Vector2d direction = unit(rng.uniform(-4.0, 4.0));
      const double max_range = rng.uniform(0.5, 12.0);
      const auto fast = caster.cast(origin, direction, max_range);
      const auto slow = cast_brute_force(segments, origin, direction, max_range);
      ASSERT_EQ(fast.has_value(), slow.has_value()) << "seed " << seed << " ray " << i;
      ASSERT_NEAR(fast.value_or(0.0), slow.value_or(0.0), 1e-9) << "seed " << seed << " ray " << i;
      hits += fast.has_value();
    }
  }
  EXPECT_GT(hits, 20000);
}

TEST(RayCaster, AgreesWithBox2DWithinItsSinglePrecision) {
  const World world = room_with_boxes(47, 5);
  const RayCaster caster(world);
  const Simulation simulation(world, {}, 1);
  int far_off = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector2d origin(0.3 * std::cos(i), 0.3 * std::sin(i)), direction = unit(0.001 * i);
    const auto ours = caster.cast(origin, direction, 30.0), theirs = simulation.cast_ray(origin, direction, 30.0);
    ASSERT_TRUE(ours && theirs) << "ray " << i;
    far_off += std::abs(*ours - *theirs) > 1e-3;
  }
  EXPECT_LE(far_off, 2) << "at the very corner of a box one may see it and the other pass";
}

TEST(RayCaster, EqualsBruteForceAlongTheAxes) {
  const World world = room_with_boxes(40, 3);
  const std::vector<Segment> segments = world.segments();
  const RayCaster caster(world);
  for (int i = 1; i < 1000; ++i) {  // not along the wall itself: the slow twin passes parallels by
    const double place = -5.0 + i * 0.01;
    for (const Vector2d& d : {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1)}) {
      const Vector2d origin = Vector2d(d.y(), d.x()).cwiseAbs() * place;
      const auto slow = cast_brute_force(segments, origin, d, 30.0);
      EXPECT_NEAR(caster.cast(origin, d, 30.0).value_or(-1.0), slow.value_or(-1.0), 1e-9) << origin.transpose();
    }
  }
}

}  // namespace
}  // namespace cogslam
