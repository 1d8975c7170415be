#include <gmock/gmock.h>

#include "tests/support/slam_run.hpp"

// Scans that wait, and the maps without them.

namespace cogslam {
namespace {

/// What the path says the map is: every registered scan written at its pose.
Grid<float> map_of(const std::vector<RegisteredPose>& path, const SyntheticLog& log, const SlamConfig& config) {
  Grid<float> map(*config.map_frame());
  MapUpdater updater;
  for (const RegisteredPose& pose : path) {
    updater.integrate(sweep_of(log.readings[pose.record], config.sweep), pose.T_map_base, config.log_odds, map);
  }
  return map;
}

TEST(FastSlam, ReportsAMapThatHoldsTheScansWhichStillWait) {
  const SyntheticLog log = drive_round(90, 21);
  for (const int waiting : {0, 1, 5, 1000}) {
    SlamConfig config = config_for(log, 4);
    config.loops.waiting_scans = waiting;
    Workers workers(2);
    FastSlam filter(config, 1, workers);
    for (const Reading& reading : log.readings) filter.update(reading);
    ASSERT_GT(filter.statistics().registered, 20);
    EXPECT_EQ(filter.best_map(), map_of(filter.best_path(), log, config)) << waiting << " scans wait";
  }
}

TEST(FastSlam, KeepsScansThatWaitOutOfTheMaps) {
  const SyntheticLog log = drive_round(60, 22);
  SlamConfig config = config_for(log, 4);
  config.loops.waiting_scans = 1000;
  Workers workers(2);
  FastSlam filter(config, 1, workers);
  for (const Reading& reading : log.readings) filter.update(reading);
  EXPECT_EQ(filter.statistics().payload_bytes, 0.0);
  const auto registered = static_cast<double>(filter.statistics().registered);
  const double scans = registered * static_cast<double>(sizeof(WaitingScan) + 120 * sizeof(float));  // for all
  const double poses = registered * sizeof(StoredPose);                                              // for each
  EXPECT_GE(filter.statistics().last.bytes, sizeof(Particle) + poses + scans / config.particles);
  EXPECT_EQ(filter.statistics().resamplings, 0);  // nothing to weigh against
}

/// Where a loop closes, the scans that wait move along: their poses on the path stay as tracking tied them.
TEST(FastSlam, MovesWaitingScansWithAClosedLoop) {
  const SyntheticLog log = drive_round(140, 23);
  SlamConfig config = config_for(log, 4);
  config.particles = 1;
  config.registration.distance = 0.15;
  config.loops = {.waiting_scans = 4, .drift_position = 0.5, .drift_heading = 0.3, .least_way = 3.0};
  Workers workers(1);
  FastSlam filter(config, 1, workers);
  int moved = 0;
  std::vector<RegisteredPose> before;
  Pose2 T_odom_before;
  for (const Reading& reading : log.readings) {
    if (!filter.update(reading)) continue;
    const Pose2 T_before_now = T_odom_before.inverse() * filter.T_odom_base();
    T_odom_before = filter.T_odom_base();
    const std::vector<RegisteredPose> path = filter.best_path();
    if (before.size() > 4 && path[path.size() - 2].T_map_base != before.back().T_map_base) {
      ++moved;
      const std::size_t n = before.size();
      const Pose2 T = path[n - 1].T_map_base * before[n - 1].T_map_base.inverse();
      for (std::size_t i = 0; i < n; ++i) {
        const Pose2 expected = i + 4 < n ? before[i].T_map_base : T * before[i].T_map_base;
        EXPECT_NEAR((path[i].T_map_base.position() - expected.position()).norm(), 0.0, 1e-6) << i << " of " << n;
        EXPECT_EQ(path[i].record, before[i].record);
      }
      // The move takes the tracked pose to the matched one.
      const Pose2 closed = T * before.back().T_map_base * T_before_now;
      EXPECT_NEAR((path.back().T_map_base.position() - closed.position()).norm(), 0.0, 1e-5);
    }
    before = path;
  }
  EXPECT_GT(moved, 0);
  EXPECT_EQ(filter.best_map(), map_of(filter.best_path(), log, config));
}

/// How far off the filter ends that loses sight of everything for most of a round, while odometry errs, and then comes
/// back to where it began [m].
double error_after_blind_round(double drift_position, double sight) {
  SyntheticLog log = drive_round(135, 24);
  for (std::size_t i = 35; i < 92; ++i) {
    Reading& reading = log.readings[i];
    reading.scan->ranges.assign(reading.scan->ranges.size(), Scan::kInvalid);
    reading.motion.T_before_now.x += 0.01;  // 0.57 m in all
  }
  SlamConfig config = config_for(log, 4);
  config.registration.distance = 0.15;
  config.loops = {
      .waiting_scans = 4, .drift_position = drift_position, .drift_heading = 0.05, .sight = sight, .least_way = 4.0};
  Workers workers(2);
  FastSlam filter(config, 1, workers);
  for (const Reading& reading : log.readings) filter.update(reading);
  return (filter.T_map_base().position() - log.truth.back().position()).norm();
}

TEST(FastSlam, SeeksAClosingLoopAsFarAsItMayHaveDrifted) {
  EXPECT_LT(error_after_blind_round(0.3, 1.2), 0.06);
  EXPECT_GT(error_after_blind_round(0.0, 1.2), 0.15);   // no drift expected, none found
  EXPECT_GT(error_after_blind_round(0.3, 1e-3), 0.15);  // nothing old is ever in sight
}

}  // namespace
}  // namespace cogslam
