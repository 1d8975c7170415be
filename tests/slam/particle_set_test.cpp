#include <gmock/gmock.h>

#include "tests/support/slam_run.hpp"

// What the filter does with its particles: resampling, paths, shared memory.

namespace cogslam {
namespace {

TEST(FastSlam, ResamplesAtEveryStepOnlyWhereToldSo) {
  const SyntheticLog log = drive_round(30, 8, 60);
  SlamConfig config = config_for(log);
  config.resampling.every_step = true;
  const Outcome always = run(config, log);
  EXPECT_EQ(always.statistics.resamplings, always.statistics.registered);
  config.resampling.every_step = false;
  config.resampling.effective_share = 1e-6;  // N_eff is never so low
  EXPECT_EQ(run(config, log).statistics.resamplings, 0);
}

/// The best particle of the first weighing has at least the mean weight, so it draws a slot: resampling must not change
/// what is reported.
TEST(FastSlam, ReportsTheSameBestParticleAfterResampling) {
  const SyntheticLog log = drive_round(10, 14, 60);
  SlamConfig config = config_for(log);
  config.proposal = Proposal::kMotion;  // spreads particles and weights
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    config.resampling = {.effective_share = 1e-6, .every_step = false};
    const Outcome never = run(config, log, seed);
    config.resampling.every_step = true;
    const Outcome always = run(config, log, seed);
    std::size_t second = 1;
    while (!never.registered[second]) ++second;
    EXPECT_EQ(always.online[second], never.online[second]) << "seed " << seed;
  }
}

/// Scans that say nothing leave the maps empty; what grows then is the path tree, of which branches without a living
/// particle must be dropped.
TEST(FastSlam, DropsPathsThatNoParticleFollows) {
  SyntheticLog log = drive_round(80, 15, 4);
  for (Reading& reading : log.readings) reading.scan->ranges.assign(4, Scan::kInvalid);
  SlamConfig config = config_for(log, 20);
  config.proposal = Proposal::kMotion;
  config.compass.noise = 0.005;  // chooses hard
  config.resampling.every_step = true;
  const FilterStatistics statistics = run(config, log).statistics;
  ASSERT_GT(statistics.registered, 30);
  const double growth = 20.0 * (statistics.bytes_peak - static_cast<double>(sizeof(Particle)));
  const double all_poses = 20.0 * static_cast<double>(statistics.registered) * sizeof(RegisteredPose);
  EXPECT_LT(growth, all_poses / 4.0);  // a fifth here, spare room included; a third and more where inner branches stay
  EXPECT_EQ(statistics.payload_bytes, 0.0);
}

TEST(FastSlam, SharesMapsBetweenParticles) {
  const SyntheticLog log = drive_round(30, 11, 60);
  SlamConfig config = config_for(log);
  config.loops.waiting_scans = 3;
  const FilterStatistics statistics = run(config, log).statistics;
  const double whole = 4.0 * static_cast<double>(config_for(log).map_frame()->size());
  EXPECT_GT(statistics.payload_bytes, 0.0);
  EXPECT_LT(statistics.payload_bytes, whole);
  EXPECT_GT(statistics.bytes, statistics.payload_bytes);
  EXPECT_GE(statistics.bytes_peak, statistics.bytes);
  EXPECT_FALSE(statistics.ancestors_100.has_value());
}

TEST(FastSlam, CountsAncestorsAHundredScansBack) {
  const SyntheticLog log = drive_round(110, 12, 30);
  SlamConfig config = config_for(log, 6);
  config.registration.distance = 0.01;
  config.likelihood.beams = 20;
  const Outcome got = run(config, log);
  ASSERT_GT(got.statistics.registered, 100);
  ASSERT_TRUE(got.statistics.ancestors_100.has_value());
  EXPECT_GE(*got.statistics.ancestors_100, 1.0);
  EXPECT_LE(*got.statistics.ancestors_100, 6.0);
  config.resampling.effective_share = 1e-6;
  EXPECT_EQ(run(config, log).statistics.ancestors_100, 6.0);
}

}  // namespace
}  // namespace cogslam
