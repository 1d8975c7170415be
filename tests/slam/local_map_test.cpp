#include "slam/track/local_map.hpp"

#include <gmock/gmock.h>

#include "core/rng.hpp"
#include "tests/support/synthetic_log.hpp"

namespace cogslam {
namespace {

SurfacePoint random_point(Rng& rng, double side) {
  const double angle = rng.uniform(-3.14, 3.14);
  return {{rng.uniform(-side, side), rng.uniform(-side, side)}, {std::cos(angle), std::sin(angle)}};
}

/// With cells so small that no two points share one, the map holds the points themselves.
TEST(LocalMap, FindsTheNearestPointOfTheSameSide) {
  for (std::uint32_t round = 0; round < 30; ++round) {
    Rng rng({.seed = 90, .purpose = Purpose::kWorld, .entity = round});
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 200; ++i) points.push_back(random_point(rng, 2.0));
    LocalMap map(1, 1e-6, 0.5);
    map.add(points, RangeView({}), Pose2{});
    for (int q = 0; q < 100; ++q) {
      const SurfacePoint query = random_point(rng, 3.0);
      const double radius = rng.uniform(0.05, 0.5);
      const SurfacePoint* expected = nullptr;  // slow twin: try all
      for (const SurfacePoint& p : points) {
        const double d = (p.position - query.position).norm();
        if (d >= radius || p.normal.dot(query.normal) <= 0.5) continue;
        if (expected == nullptr || d < (expected->position - query.position).norm()) expected = &p;
      }
      const SurfacePoint* found = map.nearest(query, radius);
      ASSERT_EQ(found == nullptr, expected == nullptr) << "round " << round;
      if (found == nullptr) continue;
      ASSERT_NEAR((found->position - expected->position).norm(), 0.0, 1e-12);
    }
  }
}

TEST(LocalMap, AveragesThePointsOfACellAndForgetsOldScans) {
  LocalMap map(2, 1.0, 0.5);
  EXPECT_TRUE(map.empty());
  const SurfacePoint query{{0.5, 0.5}, {0.0, 1.0}};
  map.add({{{0.4, 0.5}, {0.0, 1.0}}}, RangeView({}), Pose2{});
  map.add({{{0.6, 0.7}, {0.0, 1.0}}}, RangeView({}), Pose2{});
  ASSERT_NE(map.nearest(query, 0.5), nullptr);
  EXPECT_TRUE(map.nearest(query, 0.5)->position.isApprox(Eigen::Vector2d(0.5, 0.6)));
  map.add({{{0.5, 0.1}, {0.0, 1.0}}}, RangeView({}), Pose2{0.0, 0.1, 0.0});  // seen from 0.1 m further up
  EXPECT_TRUE(map.nearest(query, 0.5)->position.isApprox(Eigen::Vector2d(0.55, 0.45)));
}

TEST(LocalMap, KnowsWhereItsScansSawThrough) {
  const Pose2 T_map_base{-1.0, -1.0, 0.5};
  Rng rng({.seed = 91, .purpose = Purpose::kWorld});
  Reading reading;
  reading.scan = scan_of(cornered_room(), T_map_base, 361, 0.0, rng);
  const std::vector<Beam> sweep = sweep_of(reading, {.beams = 361});
  LocalMap map(2, 0.05, 0.5);
  map.add(surface_points(sweep, 0.4), RangeView(sweep), T_map_base);
  int free = 0;
  for (const Beam& beam : sweep) {
    if (!beam.hit || beam.range < 0.8) continue;
    const Eigen::Vector2d way = (beam.end - beam.origin).normalized();
    EXPECT_FALSE(map.free_at(T_map_base * beam.end));
    EXPECT_FALSE(map.free_at(T_map_base * Eigen::Vector2d(beam.end + 0.5 * way)));
    free += map.free_at(T_map_base * Eigen::Vector2d(beam.end - 0.6 * way)) ? 1 : 0;
  }
  EXPECT_GT(free, 200);
}

TEST(SurfacePoints, HaveTheNormalsOfTheirWallsTowardsTheLaser) {
  Rng rng({.seed = 92, .purpose = Purpose::kWorld});
  Reading reading;
  reading.scan = scan_of({{{-3.0, 2.0}, {3.0, 2.0}}, {{3.0, 2.0}, {3.0, -2.0}}}, Pose2{}, 361, 0.0, rng);
  const std::vector<SurfacePoint> points = surface_points(sweep_of(reading, {.beams = 361}), 0.4);
  int upper = 0, right = 0;
  for (const SurfacePoint& p : points) {
    const bool corner = (p.position - Eigen::Vector2d(3.0, 2.0)).norm() < 0.3;
    if (corner) continue;
    const bool is_upper = std::abs(p.position.y() - 2.0) < 1e-6;
    (is_upper ? upper : right) += 1;
    EXPECT_TRUE(p.normal.isApprox(is_upper ? Eigen::Vector2d(0.0, -1.0) : Eigen::Vector2d(-1.0, 0.0), 1e-3))
        << p.position.transpose() << " has " << p.normal.transpose();
  }
  EXPECT_GT(upper, 50);
  EXPECT_GT(right, 50);
}

TEST(SurfacePoints, LeaveOutReturnsThatFormNoLine) {
  std::vector<Beam> sweep;
  Rng rng({.seed = 93, .purpose = Purpose::kWorld});
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector2d end(2.0 + rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1));
    sweep.push_back({.origin = {0.0, 0.0}, .end = end, .range = static_cast<float>(end.norm()), .hit = true});
  }
  EXPECT_LT(surface_points(sweep, 0.4).size(), 10U);
  for (Beam& beam : sweep) beam.hit = false;
  EXPECT_TRUE(surface_points(sweep, 0.4).empty());
}

}  // namespace
}  // namespace cogslam
