#include <gtest/gtest.h>

#include <cmath>

#include "eval/sense/hallway_study.hpp"
#include "eval/sense/path_log_study.hpp"
#include "eval/sense/path_offset_study.hpp"
#include "tests/support/error_text.hpp"
#include "worlds/clearance.hpp"
#include "worlds/free_space.hpp"
#include "worlds/hallway.hpp"
#include "worlds/polygon.hpp"
#include "worlds/truth_grid.hpp"

namespace cogslam {
namespace {

TEST(Hallway, HasTheSizeOfThePapersAndCloses) {
  const World world = hallway();
  const GridFrame frame = truth_grid(world, 0.25).frame();
  EXPECT_EQ(frame.width, 249);
  EXPECT_EQ(frame.height, 154);
  EXPECT_TRUE(FreeSpace(world).is_closed());
  for (const Polygon& loop : world.walls) EXPECT_FALSE(defect(loop).has_value());
  for (const Eigen::Vector2d& corner : hallway_route()) EXPECT_GT(clearance(world, corner), 0.8);
}

TEST(PathDrive, LooksAtMostAStepApartWithThePapersScanner) {
  const PathDriveConfig config{.step_m = 4.0};
  const std::vector<PathLook> looks = drive_path(hallway(), hallway_route(), config, 1);
  ASSERT_GT(looks.size(), 50U);
  for (std::size_t i = 1; i < looks.size(); ++i) {
    const Pose2 moved = looks[i - 1].T_map_base.inverse() * looks[i].T_map_base;
    EXPECT_LE(moved.position().norm(), 4.0 + 1e-9);
    EXPECT_LE(std::abs(moved.theta), radians(30.0) + 1e-9);
    EXPECT_EQ(looks[i].scan.ranges.size(), 181U);
  }
}

TEST(FaultyOdometry, IsPerfectWithoutErrorsAndLosesItsShareOfTurns) {
  FaultyOdometry perfect({0.0, 0.0, 0.0, 0.0, 0.0}, 1);
  const Pose2 moved = perfect.measure({1.0, 0.0, 0.2});
  EXPECT_NEAR(moved.x, 1.0, 1e-12);
  EXPECT_NEAR(moved.theta, 0.2, 1e-12);
  FaultyOdometry lossy({0.0, 0.08, 0.0, 0.0, 0.0}, 1);
  EXPECT_NEAR(lossy.measure({0.0, 0.0, 0.5}).theta, 0.46, 1e-12);
}

TEST(PathDeviation, TellsAcrossFromAlong) {
  PathLook look;
  look.T_map_base = {1.0, 2.0, 0.0};
  look.corridor_heading = radians(90.0);
  const std::vector<PathLook> looks{look};
  const std::vector<Pose2> found{{1.3, 2.4, radians(2.0)}};
  const PathDeviation deviation = path_deviation(looks, found);
  EXPECT_NEAR(deviation.across, 0.3, 1e-12);
  EXPECT_NEAR(deviation.along, 0.4, 1e-12);
  EXPECT_NEAR(deviation.heading, radians(2.0), 1e-12);
}

TEST(HallwayStudy, CorrectsHeadingAndCrossCorridorErrorTenfold) {
  Workers workers(2);
  const HallwayStudy study{.first_seed = 1, .seeds = 2};
  const std::vector<HallwayScore> scores = run_hallway_study(study, workers);
  for (const HallwayScore& score : scores) {
    EXPECT_LT(score.corrected.heading, 0.1 * score.odometry.heading) << "seed " << score.seed;
    EXPECT_LT(score.corrected.across, 0.1 * score.odometry.across) << "seed " << score.seed;
    EXPECT_GT(score.odometry.across, 5.0) << "the odometry is bad enough to matter";
    EXPECT_GT(score.links.not_observed, 0) << "the plain corridor hides its length";
  }
  Workers alone(1);
  EXPECT_EQ(hallway_csv(run_hallway_study(study, alone)), hallway_csv(scores));
}

/// The drive with the default settings.
HallwayScore score_of(std::uint32_t seed) { return score_hallway(run_hallway({}, {}, seed), seed); }

// In look 19 the corridor's length is barely seen, and 4 m on lies a wall that fits as well.
TEST(HallwayStudy, DoesNotSlideToAnotherWallOfTheSameLook) {
  const HallwayScore score = score_of(2199);
  EXPECT_LT(score.corrected.across, 0.2 * score.odometry.across);
}

// In look 31 cells come into the overlap and go out of it by turns, and a step of 0.002 cells goes to and fro.
TEST(HallwayStudy, ComesToRestWhereTheOverlapChangesByTurns) { EXPECT_EQ(score_of(764).links.not_estimated, 0); }

TEST(OffsetStudy, FindsOffsetsOfDrawnMapsToATwentiethOfACell) {
  Workers workers(2);
  const OffsetSummary s = summarise(run_offset_study({.draws = 60}, workers));
  EXPECT_LT(s.median_cells, 0.05);
  EXPECT_LT(s.median_turn, radians(0.1));
  EXPECT_GE(s.succeeded, 58);
  EXPECT_EQ(s.claimed_succeeded, s.claimed);
}

TEST(OffsetStudy, SaysWhatIsInconsistent) {
  EXPECT_EQ(OffsetStudy{}.check(), "");
  EXPECT_EQ(OffsetStudy{.samples = 3000}.check(),
            "samples: expected 0 (all) to 2048, the cells of a partial map, found 3000");
  EXPECT_EQ(OffsetStudy{.draws = 0}.check(), "draws: expected at least 1");
}

TEST(PathCorrection, RefusesMoreSamplesThanCells) {
  EXPECT_EQ(PathCorrectionConfig{.samples = 2049}.check(),
            "samples: expected 1 to 2048, the cells of a partial map, found 2049");
}

TEST(PathDriveConfig, SaysWhatIsInconsistent) {
  EXPECT_EQ(PathDriveConfig{.step_m = 0.0}.check(), "step_m: expected more than 0");
  EXPECT_EQ(PathDriveConfig{.step_turn = 0.0}.check(), "step_turn: expected more than 0");
}

TEST(LogPath, AsksForALaser) {
  CarmenLog log;
  log.readings.resize(2);
  log.odometry.resize(2);
  EXPECT_EQ(error_text([&] { (void)correct_log(log, "odometry.clf", {}); }),
            "odometry.clf: no laser scan in the log, expected FLASER or ROBOTLASER1 lines");
}

}  // namespace
}  // namespace cogslam
