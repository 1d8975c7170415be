#include "sensors/log/plausible.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/rng.hpp"
#include "worlds/rooms.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Reading good_reading() {
  Reading reading;
  reading.stamp = {-1'000'000'000};
  reading.motion.T_before_now = {0.1, -0.2, 3.0};
  reading.motion.covariance << 2, 1, 0, 1, 2, 0, 0, 0, 0;
  reading.heading = -3.0;
  reading.scan = Scan{.angle_first = -1.0, .angle_increment = 0.1, .range_min = 0.1, .range_max = 8.1};
  reading.scan->ranges = {0.0F, 8.1F, Scan::kNoReturn, Scan::kTooClose, Scan::kInvalid};
  return reading;
}

std::string defect_after(const std::function<void(Reading&)>& change) {
  Reading reading = good_reading();
  change(reading);
  return defect(reading).value_or("none");
}

TEST(Plausible, IsAnOrdinaryReading) {
  EXPECT_EQ(defect_after([](Reading&) {}), "none");
  EXPECT_EQ(defect_after([](Reading& r) { r = Reading{}; }), "none") << "the first record of a log";
}

TEST(Plausible, IsNoReadingBeyondItsLimits) {
  const auto expect = [](const std::function<void(Reading&)>& change, const char* words) {
    EXPECT_THAT(defect_after(change), HasSubstr(words));
  };
  expect([](Reading& r) { r.stamp.ns = std::numeric_limits<std::int64_t>::min(); }, "the stamp");
  expect([](Reading& r) { r.motion.T_before_now.x = kNan; }, "the motion is not finite");
  expect([](Reading& r) { r.motion.T_before_now.y = -1001.0; }, "too far");
  expect([](Reading& r) { r.motion.T_before_now.theta = kInfinity; }, "the motion");
  expect([](Reading& r) { r.twist.y = kInfinity; }, "the twist");
  expect([](Reading& r) { r.heading = kNan; }, "the heading");
  expect([](Reading& r) { r.scan->angle_increment = kNan; }, "the scan's angles");
  expect([](Reading& r) { r.scan->range_min = 9.0; }, "the scan's limits");
  expect([](Reading& r) { r.scan->range_max = kInfinity; }, "the scan's limits");
  expect([](Reading& r) { r.scan->time_increment.ns = -1; }, "time between beams");
  expect([](Reading& r) { r.scan->T_base_lidar.x = 101.0; }, "mounting");
  expect([](Reading& r) { r.scan->ranges[0] = -0.5F; }, "a range");
  expect([](Reading& r) { r.scan->ranges[1] = 8.2F; }, "a range");
  expect([](Reading& r) { r.scan->ranges.resize(kMostBeams + 1); }, "too many beams");
}

TEST(Plausible, IsEveryCovarianceAndNoOtherMatrix) {
  const auto is_one = [](const Eigen::Matrix3d& m) {
    return defect_after([&](Reading& r) { r.motion.covariance = m; }) == "none";
  };
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Rng rng({.seed = seed});
    Eigen::Matrix3d root;
    for (int i = 0; i < 9; ++i) root(i / 3, i % 3) = rng.normal();
    if (seed % 3 == 0) root.col(2).setZero();  // knows one direction for sure
    const Eigen::Matrix3d covariance = root * root.transpose();
    EXPECT_TRUE(is_one(covariance)) << seed;
    EXPECT_TRUE(is_one(1e-12 * covariance)) << seed;
    EXPECT_FALSE(is_one(covariance - 1.1 * covariance.trace() * Eigen::Matrix3d::Identity())) << seed;
    Eigen::Matrix3d lopsided = covariance;
    lopsided(0, 1) += 0.1 * std::sqrt(covariance(0, 0) * covariance(1, 1));
    EXPECT_FALSE(is_one(lopsided)) << seed;
  }
  Eigen::Matrix3d m;
  m << 1, -0.9, -0.9, -0.9, 1, -0.9, -0.9, -0.9, 1;  // each pair could be, all three together cannot
  EXPECT_FALSE(is_one(m));
  EXPECT_FALSE(is_one(Eigen::Matrix3d::Constant(kNan)));
  EXPECT_FALSE(is_one(kInfinity * Eigen::Matrix3d::Identity()));
}

TEST(Plausible, IsAWorldWithSurfacesInReach) {
  EXPECT_EQ(defect(cluttered_room()), std::nullopt);
  World world = cluttered_room();
  world.walls[0][0].x() = kNan;
  EXPECT_THAT(defect(world).value_or(""), HasSubstr("a corner of the world is not finite"));
  EXPECT_THAT(defect(World{}).value_or(""), HasSubstr("no surface"));
  world = cluttered_room();
  world.start.y = kInfinity;
  EXPECT_THAT(defect(world).value_or(""), HasSubstr("the pose is not finite"));
}

}  // namespace
}  // namespace cogslam
