#include "slam/fast_slam.hpp"

#include <gmock/gmock.h>

#include "tests/support/slam_run.hpp"

namespace cogslam {
namespace {

double rms_distance(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i].position() - b[i].position()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

std::vector<Pose2> odometry_of(const SyntheticLog& log) {
  std::vector<Pose2> path{log.truth.front()};
  for (std::size_t i = 1; i < log.readings.size(); ++i)
    path.push_back(path.back() * log.readings[i].motion.T_before_now);
  return path;
}

TEST(FastSlam, GivesTheSameStateForAnyNumberOfThreadsAndInEachRun) {
  const SyntheticLog log = drive_round(40, 3, 60);
  for (const auto& [name, config] : variants_for(log)) {
    const Outcome one = run(config, log, 1, 1);
    ASSERT_GT(one.statistics.payload_bytes, 0.0) << name << ": empty maps say nothing of threads";
    for (const int threads : {1, 2, 4}) {
      const Outcome other = run(config, log, 1, threads);
      EXPECT_EQ(other.hash, one.hash) << name << ", " << threads << " threads";
      EXPECT_EQ(other.online, one.online) << name << ", " << threads << " threads";
      EXPECT_EQ(other.map, one.map) << name << ", " << threads << " threads";
      EXPECT_EQ(other.statistics.bytes, one.statistics.bytes) << name << ", " << threads << " threads";
      EXPECT_EQ(other.statistics.bytes_peak, one.statistics.bytes_peak) << name << ", " << threads << " threads";
    }
  }
}

TEST(FastSlam, GivesAnotherStateForAnotherSeed) {
  const SyntheticLog log = drive_round(10, 3, 60);
  EXPECT_NE(run(config_for(log), log, 1).hash, run(config_for(log), log, 2).hash);
}

TEST(FastSlam, FollowsTheTruePathFarCloserThanOdometry) {
  const SyntheticLog log = drive_round(140, 4);
  const double odometry = rms_distance(odometry_of(log), log.truth);
  ASSERT_GT(odometry, 0.08);  // so that there is something to correct
  for (const Proposal proposal : {Proposal::kMotion, Proposal::kScanMatched}) {
    SlamConfig config = config_for(log, proposal == Proposal::kMotion ? 60 : 15);
    config.proposal = proposal;
    config.motion.least_sigma_position = config.motion.least_sigma_heading = 0.002;  // the log states its noise in full
    const Outcome got = run(config, log);
    EXPECT_LT(rms_distance(got.online, log.truth), odometry * (proposal == Proposal::kMotion ? 0.6 : 0.4));
    EXPECT_EQ(got.path.size(), static_cast<std::size_t>(got.statistics.registered));
  }
}

TEST(FastSlam, CountsRegisteredAndTrackedScans) {
  SyntheticLog log = drive_round(40, 5, 60);
  for (std::size_t i = 7; i < log.readings.size(); i += 5) log.readings[i].scan.reset();  // odometry alone
  SlamConfig config = config_for(log);
  config.tracker.used = false;  // so that what is due follows from the log's own odometry
  const Outcome got = run(config, log);
  EXPECT_TRUE(got.registered.front());
  std::int64_t registered = 0, scans = 0;
  std::vector<std::size_t> records;
  MotionModel since_registered(config.motion);
  for (std::size_t i = 0; i < log.readings.size(); ++i) {
    const Reading& reading = log.readings[i];
    since_registered.add(reading.motion);
    const bool due = reading.scan && (i == 0 || config.registration.due(since_registered.T_last_now()));
    EXPECT_EQ(got.registered[i], due) << i;
    scans += reading.scan ? 1 : 0;
    if (!due) continue;
    ++registered;
    records.push_back(i);
    since_registered.restart();
  }
  EXPECT_GT(registered, 10);
  EXPECT_GT(scans, registered);
  EXPECT_EQ(got.statistics.registered, registered);
  EXPECT_EQ(got.statistics.tracked, scans - registered);
  std::vector<std::size_t> path_records;
  for (const RegisteredPose& pose : got.path) path_records.push_back(pose.record);
  EXPECT_EQ(path_records, records);
}

TEST(FastSlam, RegistersNothingAtAStandstillAfterTheFirstScan) {
  SyntheticLog log = drive_round(1, 6);
  for (int i = 0; i < 20; ++i) {
    Reading again = log.readings.front();
    again.sequence = static_cast<std::uint64_t>(i) + 1;
    log.readings.push_back(again);
  }
  const Outcome got = run(config_for(log), log);
  EXPECT_EQ(got.statistics.registered, 1);
  EXPECT_EQ(got.statistics.tracked, 20);
  EXPECT_EQ(got.statistics.resamplings, 0);
  EXPECT_NEAR((got.online.back().position() - log.truth.front().position()).norm(), 0.0, 1e-4);
  EXPECT_NEAR(got.online.back().theta, log.truth.front().theta, 1e-4);
}

/// Odometry alone, or odometry refined by tracking.
TEST(FastSlam, MovesOnByItsOdometryBetweenRegisteredScans) {
  const SyntheticLog log = drive_round(20, 7, 60);
  for (const bool tracking : {false, true}) {
    SlamConfig config = config_for(log);
    config.tracker.used = tracking;
    Workers workers(1);
    FastSlam slam(config, 1, workers);
    Pose2 before = slam.T_map_base(), odometry = slam.T_odom_base();
    for (const Reading& reading : log.readings) {
      const bool registered = slam.update(reading);
      const Pose2 told = odometry.inverse() * slam.T_odom_base(), expected = before * told;
      if (!registered) {
        EXPECT_NEAR((slam.T_map_base().position() - expected.position()).norm(), 0.0, 1e-12);
        EXPECT_NEAR(wrap_angle(slam.T_map_base().theta - expected.theta), 0.0, 1e-12);
      }
      if (!tracking) {
        EXPECT_NEAR((told.position() - reading.motion.T_before_now.position()).norm(), 0.0, 1e-12);
      }
      before = slam.T_map_base(), odometry = slam.T_odom_base();
    }
  }
}

TEST(FastSlam, TakesNearlyTheSamePathWithAllCoefficients) {
  const SyntheticLog log = drive_round(40, 9);
  SlamConfig config = config_for(log);
  const Outcome dense = run(config, log);
  config.store = {.kind = StoreKind::kCoefficients, .percent_kept = 100.0};
  const Outcome coefficients = run(config, log);
  // Float rounding in the map may tip a search step or a draw, and from there on the two are different runs of one
  // filter.
  EXPECT_LT(rms_distance(dense.online, coefficients.online), 0.02);
  EXPECT_EQ(dense.registered, coefficients.registered);
  EXPECT_GT(coefficients.statistics.payload_bytes, 0.0);
}

TEST(FastSlam, LetsLogOddsGrowWithoutTheClamp) {
  const SyntheticLog log = drive_round(60, 10);
  SlamConfig config = config_for(log);
  const auto largest = [](const Grid<float>& map) {
    return *std::max_element(map.values().begin(), map.values().end());
  };
  const auto least = [](const Grid<float>& map) { return *std::min_element(map.values().begin(), map.values().end()); };
  const Grid<float> clamped = run(config, log).map;
  EXPECT_LE(largest(clamped), config.log_odds.max);
  EXPECT_GE(least(clamped), config.log_odds.min);
  config.log_odds.clamped = false;
  const Grid<float> unclamped = run(config, log).map;
  EXPECT_GT(largest(unclamped), config.log_odds.max);
  EXPECT_LT(least(unclamped), config.log_odds.min);
}

/// Every stage that one thread enters, in order; leaving is '.'.
struct StageLog : StageListener {
  std::string letters;
  void enter(int /*worker*/, Stage stage) override { letters += "TPLWDSR"[static_cast<std::size_t>(stage)]; }
  void leave(int /*worker*/) override { letters += '.'; }
};

TEST(FastSlam, TellsWhichStageItWorksOn) {
  const SyntheticLog log = drive_round(30, 9, 60);
  SlamConfig config = config_for(log, 2);
  config.loops.waiting_scans = 0;
  config.resampling.every_step = true;
  StageLog stages;
  Workers workers(1);
  FastSlam filter(config, 1, workers, &stages);
  filter.update(log.readings[0]);
  EXPECT_EQ(stages.letters, "TPLD.LD.SRT.");  // nothing to weigh against yet
  int registered = 0;
  for (std::size_t i = 1; i < log.readings.size(); ++i) {
    stages.letters.clear();
    const bool taken = filter.update(log.readings[i]);
    EXPECT_EQ(stages.letters, taken ? "TPLWD.LWD.SRT." : "T.");
    registered += taken ? 1 : 0;
  }
  EXPECT_GT(registered, 0);
}

}  // namespace
}  // namespace cogslam
