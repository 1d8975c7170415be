#include <gmock/gmock.h>

#include "slam/health/map_watch.hpp"
#include "slam/health/odometry_watch.hpp"
#include "slam/health/scan_watch.hpp"
#include "tests/support/mapped_room.hpp"
#include "tests/support/slam_run.hpp"

namespace cogslam {
namespace {

Reading reading_of(const Pose2& motion, std::vector<float> ranges) {
  Reading reading;
  reading.motion.T_before_now = motion;
  if (!ranges.empty()) reading.scan = Scan{.ranges = std::move(ranges)};
  return reading;
}

FilterHealth watch_scans(const std::vector<Reading>& readings) {
  FilterHealth health;
  ScanWatch watch;
  for (const Reading& reading : readings) watch.see(reading, health);
  return health;
}

TEST(ScanWatch, CountsRecordsWithoutAScanAndScansWithoutReturns) {
  const std::vector<float> nothing(100, Scan::kNoReturn);
  std::vector<float> some = nothing;
  for (std::size_t i = 0; i < 10; ++i) some[i] = 2.0F;
  const FilterHealth health = watch_scans(
      {reading_of({}, some), reading_of({}, {}), reading_of({}, nothing), reading_of({0.1, 0.0, 0.0}, nothing)});
  EXPECT_EQ(health.records, 4);
  EXPECT_EQ(health.scans_missing, 1);
  EXPECT_EQ(health.blind_scans, 2);
  Reading of_a_log = reading_of({}, {});
  of_a_log.motion.source = MotionSource::kLog;
  EXPECT_EQ(watch_scans({of_a_log}).scans_missing, 0);
  EXPECT_EQ(health.repeated_scans, 0) << "nothing is nothing, wherever it is seen from";
}

TEST(ScanWatch, CallsARepeatedScanFrozenOnlyOnceTheRobotMoved) {
  const std::vector<float> a(50, 1.0F), b(50, 1.5F);
  const Pose2 step{0.003, 0.0, 0.0};
  EXPECT_EQ(watch_scans({reading_of({}, a), reading_of({}, a), reading_of({}, a)}).repeated_scans, 0);
  EXPECT_EQ(watch_scans({reading_of(step, a), reading_of(step, b), reading_of(step, a)}).repeated_scans, 0);
  EXPECT_EQ(
      watch_scans({reading_of(step, a), reading_of(step, a), reading_of(step, a), reading_of(step, a)}).repeated_scans,
      2)
      << "after 6 and 9 mm, not after 3";
  EXPECT_EQ(watch_scans({reading_of({}, a), reading_of({0.0, 0.0, 0.1}, a)}).repeated_scans, 1);
}

TEST(OdometryWatch, DoubtsOnlyWhatItsOwnCovarianceDoesNotCover) {
  FilterHealth health;
  OdometryWatch watch;
  MotionIncrement motion;
  motion.T_before_now = {0.05, 0.0, 0.0};
  motion.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-6).asDiagonal();
  Pose2 T_track_base;
  const auto drive = [&](int steps, double share) {
    for (int i = 0; i < steps; ++i) {
      T_track_base = T_track_base * Pose2{share * 0.05, 0.0, 0.0};
      watch.see(motion, T_track_base, true, health);
    }
  };
  drive(60, 1.0);
  EXPECT_EQ(health.odometry_checks, 30);
  EXPECT_EQ(health.odometry_doubted, 0);
  drive(20, 0.3);  // the wheels turn, the robot hardly moves
  EXPECT_EQ(health.odometry_checks, 40);
  EXPECT_EQ(health.odometry_doubted, 10);
  motion.covariance = Eigen::Vector3d(4e-4, 4e-4, 1e-6).asDiagonal();
  drive(20, 0.3);
  EXPECT_EQ(health.odometry_doubted, 10) << "it says itself that it slips";
}

BestLook look(int known, int contradicted) { return {.scan = {known, contradicted}, .heading_sigmas = {}}; }

TEST(MapWatch, CountsContradictedScansAndTheLongestRunOfThem) {
  FilterHealth health;
  MapWatch watch;
  for (const int contradicted : {10, 60, 60, 10, 60, 60, 60, 50}) watch.see(look(100, contradicted), 20.0, 30, health);
  watch.see(look(10, 10), 20.0, 30, health);
  EXPECT_EQ(health.scans_judged, 8) << "ten known probes say nothing";
  EXPECT_EQ(health.scans_doubted, 5);
  EXPECT_EQ(health.beams_known, 800);
  EXPECT_EQ(health.beams_doubted, 370);
  EXPECT_EQ(health.longest_doubt, 3);
}

TEST(MapWatch, CountsHeadingsThatCannotBeAndParticlesThatDoNotCount) {
  FilterHealth health;
  MapWatch watch;
  for (const double sigmas : {0.1, 3.9, 4.1}) watch.see({.scan = {}, .heading_sigmas = sigmas}, 20.0, 30, health);
  watch.see({}, 1.2, 30, health);
  watch.see({}, 1.0, 1, health);
  EXPECT_EQ(health.headings, 3);
  EXPECT_EQ(health.headings_doubted, 1);
  EXPECT_EQ(health.collapses, 1) << "of one particle there is never more than one";
}

TEST(ScanAgreement, IsGoodAtTheTruePoseAndBadElsewhere) {
  const Grid<float> room = mapped_cornered_room(0.1);
  ScanLikelihood likelihood({}, 0.1);
  likelihood.look_at(room);
  const Pose2 truth{-0.4, -0.7, 0.6};
  const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), truth, 720));
  const ScanAgreement right = likelihood.agreement(probes, truth);
  EXPECT_GT(right.known, 150);
  EXPECT_LT(right.contradicted, right.known / 20);
  const ScanAgreement wrong = likelihood.agreement(probes, {-0.4, -0.1, 1.1});
  EXPECT_GT(wrong.contradicted, wrong.known / 2);
}

TEST(ScanAgreement, KnowsNothingOfAnEmptyMap) {
  Grid<float> nothing = mapped_cornered_room(0.1);
  for (float& value : nothing.values()) value = 0.0F;
  ScanLikelihood likelihood({}, 0.1);
  likelihood.look_at(nothing);
  const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), {}, 90));
  EXPECT_EQ(likelihood.agreement(probes, {}).known, 0);
}

FilterHealth health_of(const SyntheticLog& log, int threads) {
  Workers workers(threads);
  FastSlam filter(config_for(log), 1, workers);
  for (const Reading& reading : log.readings) filter.update(reading);
  return filter.health();
}

TEST(FilterHealth, IsGoodOnASoundLogAndTheSameForAnyNumberOfThreads) {
  const SyntheticLog log = drive_round(120, 3);
  const FilterHealth health = health_of(log, 1);
  EXPECT_EQ(health.records, 120);
  EXPECT_EQ(health.scans_missing + health.blind_scans + health.repeated_scans, 0);
  EXPECT_GT(health.odometry_checks, 30);
  EXPECT_EQ(health.odometry_doubted, 0);
  EXPECT_GT(health.scans_judged, 20);
  EXPECT_EQ(health.scans_doubted, 0);
  EXPECT_GT(health.headings, 30);
  EXPECT_EQ(health.headings_doubted, 0);
  EXPECT_EQ(health_of(log, 3), health);
}

/// In so small a room the scans soon agree with what is drawn anew around the wrong place: only the compass tells.
TEST(FilterHealth, TellsAKidnappingByHeadings) {
  SyntheticLog log = drive_round(160, 3);
  log.readings.erase(log.readings.begin() + 80, log.readings.begin() + 120);  // 2 m and 110 degrees without a word
  EXPECT_GT(health_of(log, 2).headings_doubted, 10);
}

TEST(FilterHealth, AFrozenLidarDoesNotHoldTheRobotBack) {
  SyntheticLog log = drive_round(120, 3);
  for (std::size_t i = 60; i < 90; ++i) log.readings[i].scan = log.readings[59].scan;
  Workers workers(2);
  FastSlam filter(config_for(log), 1, workers);
  double farthest = 0.0;
  for (std::size_t i = 0; i < log.readings.size(); ++i) {
    filter.update(log.readings[i]);
    farthest = std::max(farthest, (filter.T_map_base().position() - log.truth[i].position()).norm());
  }
  EXPECT_EQ(filter.health().repeated_scans, 30);
  EXPECT_LT(farthest, 0.15) << "odometry alone carries it for 1.5 m";
}

}  // namespace
}  // namespace cogslam
