#include "worlds/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/rng.hpp"

namespace cogslam {
namespace {

const Polygon kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Polygon kAngle{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST(Polygon, AreaIsPositiveCounterClockwise) {
  EXPECT_DOUBLE_EQ(signed_area(kSquare), 4.0);
  EXPECT_DOUBLE_EQ(signed_area({kSquare.rbegin(), kSquare.rend()}), -4.0);
  EXPECT_DOUBLE_EQ(signed_area(kAngle), 5.0);
}

TEST(Polygon, InsideKnowsTheHollowOfAnAngle) {
  EXPECT_TRUE(inside(kAngle, {0.5, 2.5}));
  EXPECT_TRUE(inside(kAngle, {2.5, 0.5}));
  EXPECT_FALSE(inside(kAngle, {2, 2}));
  EXPECT_FALSE(inside(kAngle, {-1, 1}));
}

TEST(Polygon, DistanceToASegmentCountsItsEnds) {
  const Segment s{{0, 0}, {4, 0}};
  EXPECT_DOUBLE_EQ(distance(s, Eigen::Vector2d{1, 2}), 2.0);
  EXPECT_DOUBLE_EQ(distance(s, Eigen::Vector2d{7, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distance(Segment{{1, 1}, {1, 1}}, Eigen::Vector2d{4, 5}), 5.0);
}

TEST(Polygon, SegmentsTouchWhereTheyCrossMeetOrOverlap) {
  const Segment s{{0, 0}, {4, 0}};
  EXPECT_TRUE(touch(s, {{1, -1}, {2, 1}}));
  EXPECT_TRUE(touch(s, {{4, 0}, {5, 3}}));
  EXPECT_TRUE(touch(s, {{2, 0}, {2, 3}}));
  EXPECT_TRUE(touch(s, {{3, 0}, {6, 0}}));
  EXPECT_FALSE(touch(s, {{5, 0}, {6, 0}}));
  EXPECT_FALSE(touch(s, {{1, 0.001}, {2, 1}}));
}

TEST(Polygon, SegmentDistanceEqualsTheLeastOverManyPoints) {
  Rng rng({.seed = 3, .purpose = Purpose::kWorld});
  for (int i = 0; i < 200; ++i) {
    const auto point = [&rng] { return Eigen::Vector2d{rng.uniform(-1, 1), rng.uniform(-1, 1)}; };
    const Segment s{point(), point()}, t{point(), point()};
    double least = 10.0;
    for (int k = 0; k <= 2000; ++k) least = std::min(least, distance(s, t.a + (t.b - t.a) * (k / 2000.0)));
    EXPECT_LE(distance(s, t), least + 1e-12);
    EXPECT_NEAR(distance(s, t), least, 2e-3);
  }
}

TEST(Polygon, BoxTurnsAboutItsMiddle) {
  const Polygon b = box({1.0, 2.0, std::numbers::pi / 2}, 0.6, 0.2);
  EXPECT_NEAR(signed_area(b), 0.12, 1e-12);
  EXPECT_NEAR((b[0] - Eigen::Vector2d{1.1, 1.7}).norm(), 0.0, 1e-12);
  EXPECT_NEAR((b[2] - Eigen::Vector2d{0.9, 2.3}).norm(), 0.0, 1e-12);
}

TEST(Polygon, NamesTheDefectOfALoop) {
  EXPECT_FALSE(defect(kSquare));
  EXPECT_FALSE(defect(kAngle));
  EXPECT_FALSE(defect({{0, 0}, {1, 0}, {2, 0}, {2, 2}})) << "a corner on a straight side does no harm";
  EXPECT_EQ(defect({{0, 0}, {1, 0}}), "has 2 corners, expected at least 3");
  EXPECT_EQ(defect({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), "crosses itself: the edges from corner 1 and from corner 3 meet");
  EXPECT_EQ(defect({{0, 0}, {1, 0}, {1, 0}, {0, 2}}), "names corner 2 twice in a row");
  EXPECT_EQ(defect({{0, 0}, {1, 0}, {2, 0}}), "crosses itself: the edges from corner 1 and from corner 3 meet");
  EXPECT_EQ(defect({{0, 0}, {2, 0}, {1, 0}, {1, 2}}), "crosses itself: the edges from corner 1 and from corner 2 meet");
  EXPECT_EQ(defect({{0, 0}, {1e-4, 0}, {0, 1e-4}}), "has no area");
  EXPECT_TRUE(defect({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})) << "a corner that touches another side";
}

}  // namespace
}  // namespace cogslam
