#include "sensors/sensor_suite.hpp"

#include <gmock/gmock.h>

#include "tests/support/test_worlds.hpp"

namespace cogslam {
namespace {

Truth truth_at(std::int64_t us) {
  Truth t;
  t.time = {us * 1000};
  t.T_map_base = Pose2::exp(1e-6 * static_cast<double>(us) * Twist2{0.3, 0.1, 0.5});
  t.twist = {0.3, 0.1, 0.5};
  t.wheel_angles = {1e-6 * static_cast<double>(us), 0.0, 0.0, 0.0};
  return t;
}

SensorOutput run(SensorSuite suite, int ms, int step_us = 1000) {
  SensorOutput all;
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  for (int us = 0; us <= 1000 * ms; us += step_us) {
    const SensorOutput& out = suite.step(truth_at(us));
    append(all.wheels, out.wheels);
    append(all.compass, out.compass);
    append(all.camera_due, out.camera_due);
    append(all.reference, out.reference);
    append(all.scans, out.scans);
  }
  return all;
}

SensorSuiteConfig with_camera() {
  SensorSuiteConfig config;
  config.camera_rate_hz = 30.0;
  return config;
}

TEST(SensorSuite, ReadsEachSensorAtItsOwnRate) {
  const SensorOutput out = run(SensorSuite(with_camera(), square_room(4.0), 1), 1000);
  EXPECT_EQ(out.wheels.size(), 51u);
  EXPECT_EQ(out.compass.size(), 51u);
  EXPECT_EQ(out.camera_due.size(), 31u);
  EXPECT_EQ(out.reference.size(), 11u);
  EXPECT_EQ(out.scans.size(), 40u);  // the one that began at 1 s is not swept yet
  for (std::size_t n = 0; n < out.scans.size(); ++n)
    EXPECT_EQ(out.scans[n].stamp, Time{static_cast<std::int64_t>(n) * 25'000'000});
}

TEST(SensorSuite, GivesAScanWhenItsLastBeamIsIn) {
  SensorSuite suite(SensorSuiteConfig{}, square_room(4.0), 1);
  for (int ms = 0; ms < 18; ++ms) EXPECT_TRUE(suite.step(truth_at(1000 * ms)).scans.empty()) << ms;
  EXPECT_TRUE(suite.step(truth_at(18000)).scans.empty());
  EXPECT_EQ(suite.step(truth_at(19000)).scans.size(), 1u);
}

TEST(SensorSuite, TellsTheCameraItsTrueStateBetweenTwoSteps) {
  const SensorOutput out = run(SensorSuite(with_camera(), square_room(4.0), 1), 100);
  const Truth& second = out.camera_due.at(1);
  EXPECT_EQ(second.time, Time{33'333'333});
  const Pose2 expected = Pose2::exp(0.033333333 * Twist2{0.3, 0.1, 0.5});
  EXPECT_LT((second.T_map_base.position() - expected.position()).norm(), 1e-7);
  EXPECT_NEAR(second.T_map_base.theta, expected.theta, 1e-12);
  EXPECT_EQ(second.twist, (Twist2{0.3, 0.1, 0.5}));
}

TEST(SensorSuite, DoesNotDependOnTheStepOfTheSimulation) {
  const SensorOutput fine = run(SensorSuite(with_camera(), square_room(4.0), 1), 500);
  const SensorOutput coarse = run(SensorSuite(with_camera(), square_room(4.0), 1), 500, 5000);
  ASSERT_EQ(fine.scans.size(), coarse.scans.size());
  ASSERT_EQ(fine.compass.size(), coarse.compass.size());
  for (std::size_t n = 0; n < fine.compass.size(); ++n)
    EXPECT_NEAR(fine.compass[n].heading, coarse.compass[n].heading, 1e-12);
}

TEST(SensorSuite, OneSensorsRateLeavesTheOthersDrawsAlone) {
  SensorSuiteConfig other = with_camera();
  other.compass.rate_hz = 0.0;
  other.reference.rate_hz = 7.0;
  const SensorOutput a = run(SensorSuite(with_camera(), square_room(4.0), 1), 300);
  const SensorOutput b = run(SensorSuite(other, square_room(4.0), 1), 300);
  EXPECT_TRUE(b.compass.empty());
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t n = 0; n < a.scans.size(); ++n) EXPECT_EQ(a.scans[n].scan, b.scans[n].scan);
}

TEST(SensorSuite, RepeatsItselfAndDiffersByTheSeed) {
  const SensorOutput a = run(SensorSuite(with_camera(), square_room(4.0), 1), 100);
  const SensorOutput b = run(SensorSuite(with_camera(), square_room(4.0), 1), 100);
  const SensorOutput c = run(SensorSuite(with_camera(), square_room(4.0), 2), 100);
  EXPECT_EQ(a.scans[2].scan, b.scans[2].scan);
  EXPECT_EQ(a.reference, b.reference);
  EXPECT_NE(a.scans[2].scan, c.scans[2].scan);
  EXPECT_NE(a.compass[2].heading, c.compass[2].heading);
}

TEST(SensorSuite, StartsWithTheFirstTruthThatItIsGiven) {
  SensorSuite suite(with_camera(), square_room(4.0), 1);
  EXPECT_TRUE(suite.step(truth_at(1000)).compass.empty());
  for (int ms = 2; ms < 20; ++ms) suite.step(truth_at(1000 * ms));
  EXPECT_EQ(suite.step(truth_at(20000)).compass.size(), 1u);
}

TEST(SensorSuite, ReadsItsSections) {
  ConfigSection s = ConfigSection::parse(
      "lidar: {preset: lms200, rate_hz: 5}\ncompass: {rate_hz: 10}\nreference: {rate_hz: 2}\nwheels: {ticks_per_turn: "
      "64}\n",
      "s.yaml");
  const SensorSuiteConfig c = read_sensor_suite_config(s);
  s.finish();
  EXPECT_EQ(c.lidar.rate_hz, 5.0);
  EXPECT_EQ(c.lidar.beams, 181);
  EXPECT_EQ(c.compass.rate_hz, 10.0);
  EXPECT_EQ(c.reference.rate_hz, 2.0);
  EXPECT_EQ(c.wheels.ticks_per_turn, 64);
}

TEST(SensorSuite, FaultsOfOneSensorLeaveTheOthersAlone) {
  SensorSuiteConfig faulty = with_camera();
  faulty.faults.streams = {{.kind = StreamFaultKind::kDropout, .sensor = SensorKind::kLidar, .probability = 0.5},
                           {.kind = StreamFaultKind::kFrozen, .sensor = SensorKind::kCompass}};
  const SensorOutput a = run(SensorSuite(with_camera(), square_room(4.0), 1), 1000);
  const SensorOutput b = run(SensorSuite(faulty, square_room(4.0), 1), 1000);
  ASSERT_EQ(b.scans.size(), a.scans.size());
  int lost = 0;
  for (std::size_t n = 0; n < a.scans.size(); ++n) {
    EXPECT_EQ(b.scans[n].stamp, a.scans[n].stamp);
    if (b.scans[n].scan.ranges.empty()) {
      ++lost;
    } else {
      EXPECT_EQ(b.scans[n].scan, a.scans[n].scan);
    }
  }
  EXPECT_GT(lost, 8);
  EXPECT_LT(lost, 32);
  for (const CompassSample& sample : b.compass) EXPECT_EQ(sample.heading, a.compass[0].heading);
  for (std::size_t n = 0; n < a.wheels.size(); ++n) EXPECT_EQ(b.wheels[n].angles, a.wheels[n].angles);
}

TEST(SensorSuite, SeesThroughGlassToWhatStandsBehindIt) {
  World glazed = square_room(4.0);
  glazed.panes = {{{1.0, -1.5}, {1.0, 1.5}}};
  const SensorOutput a = run(SensorSuite(with_camera(), square_room(4.0), 1), 100);
  const SensorOutput b = run(SensorSuite(with_camera(), glazed, 1), 100);
  ASSERT_FALSE(a.scans.empty());
  for (std::size_t n = 0; n < a.scans.size(); ++n) EXPECT_EQ(b.scans[n].scan, a.scans[n].scan);
}

}  // namespace
}  // namespace cogslam
