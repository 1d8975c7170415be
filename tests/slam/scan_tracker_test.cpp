#include "slam/track/scan_tracker.hpp"

#include <gmock/gmock.h>

#include "tests/support/error_text.hpp"
#include "tests/support/synthetic_log.hpp"

namespace cogslam {
namespace {

/// Scans with noise of a centimetre from places of the cornered room.
class Drive {
 public:
  explicit Drive(std::uint32_t seed) : rng_({.seed = seed, .purpose = Purpose::kWorld}) {}

  /// The reading at `T_map_base`, to which odometry tells `told` of the way.
  Reading reading(const Pose2& T_map_base, const Pose2& told) {
    Reading reading;
    reading.motion.T_before_now = told;
    const double way = std::hypot(told.x, told.y), turn = std::abs(told.theta);
    const double position = 0.03 * way + 1e-4, heading = 0.07 * turn + 0.07 * way + 1e-4;
    reading.motion.covariance =
        Eigen::Vector3d(position * position, position * position, heading * heading).asDiagonal();
    reading.scan = scan_of(cornered_room(), T_map_base, 361, 0.01, rng_);
    return reading;
  }
  Rng& rng() { return rng_; }

 private:
  Rng rng_;
};

double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

/// Along a circle, with odometry whose way is 5 % and whose turn is 10 % too long.
TEST(ScanTracker, TakesOutWhatOdometryIsWrongBy) {
  Drive drive(80);
  ScanTracker tracker(TrackerConfig{}, SweepConfig{});
  const Pose2 start{-1.4, -1.0, 0.2}, step{0.04, 0.0, 0.02}, told{0.042, 0.0, 0.022};
  Pose2 truth = start, odometry = start;
  for (int k = 0; k < 60; ++k) {
    if (k > 0) truth = truth * step, odometry = odometry * told;
    tracker.follow(drive.reading(truth, k > 0 ? told : Pose2{}));
    if (k % 8 == 0) tracker.make_key();
  }
  const Pose2 tracked = start * tracker.T_track_base();
  EXPECT_GT(distance(odometry, truth), 0.1);
  EXPECT_LT(distance(tracked, truth), 0.015);
  EXPECT_LT(std::abs(wrap_angle(tracked.theta - truth.theta)), 0.01);
}

TEST(ScanTracker, StatesACovarianceThatHoldsItsErrors) {
  double squares = 0.0;
  constexpr int kRounds = 60;
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    Drive drive(100 + round);
    ScanTracker tracker(TrackerConfig{}, SweepConfig{});
    const Pose2 truth{-1.2, -0.9, 0.4}, step{0.1, 0.02, 0.05};
    tracker.follow(drive.reading(truth, {}));
    tracker.make_key();
    tracker.follow(drive.reading(truth * step, {0.11, 0.01, 0.04}));
    const Twist2 error = (step.inverse() * tracker.T_key_now()).log();
    const Eigen::Vector3d e(error.x, error.y, error.theta);
    squares += e.dot(tracker.covariance().inverse() * e);
  }
  EXPECT_LT(squares / kRounds, 3.0 * 2.0);  // three degrees of freedom; at most twice as bold as it should be
  EXPECT_GT(squares / kRounds, 3.0 * 0.02);
}

TEST(ScanTracker, SpreadsMotionByAShareOfItsCovarianceAndALeast) {
  Drive drive(81);
  const TrackerConfig config{.spread = 0.4, .spread_position = 0.01, .spread_heading = 0.02};
  ScanTracker tracker(config, SweepConfig{});
  tracker.follow(drive.reading({-1.2, -0.9, 0.4}, {}));
  tracker.make_key();
  tracker.follow(drive.reading({-1.1, -0.9, 0.4}, {0.1, 0.0, 0.0}));
  const Eigen::Matrix3d least = Eigen::Vector3d(1e-4, 1e-4, 4e-4).asDiagonal();
  EXPECT_TRUE(tracker.spread().isApprox(0.16 * tracker.covariance() + least, 1e-12)) << tracker.spread();
  EXPECT_GT(tracker.covariance()(0, 0), 0.0);
}

/// What real logs do: a record comes late, and the next makes up for it.
TEST(ScanTracker, FollowsScansWhereOdometryLagsAStepBehind) {
  Drive drive(81);
  ScanTracker tracker(TrackerConfig{}, SweepConfig{});
  Pose2 truth{-1.3, -1.0, 0.0};
  const Pose2 start = truth, step{0.05, 0.0, 0.0}, leap{0.5, 0.1, 0.6};
  tracker.follow(drive.reading(truth, {}));
  tracker.make_key();
  for (int k = 0; k < 5; ++k) {
    truth = truth * step;
    tracker.follow(drive.reading(truth, step));
  }
  truth = truth * leap;
  tracker.follow(drive.reading(truth, Pose2{}));  // odometry says nothing of the leap
  EXPECT_LT(distance(start * tracker.T_track_base(), truth), 0.03);
  truth = truth * step;
  tracker.follow(drive.reading(truth, leap * step));  // and now tells it
  EXPECT_LT(distance(start * tracker.T_track_base(), truth), 0.03);
}

TEST(ScanTracker, FollowsOdometryWithoutScans) {
  ScanTracker tracker(TrackerConfig{}, SweepConfig{});
  Reading reading;
  reading.motion.T_before_now = {0.3, -0.1, 0.2};
  reading.motion.covariance = Eigen::Vector3d(0.01, 0.02, 0.003).asDiagonal();
  tracker.follow(reading);
  tracker.follow(reading);
  const Pose2 twice = reading.motion.T_before_now * reading.motion.T_before_now;
  EXPECT_NEAR(distance(tracker.T_key_now(), twice), 0.0, 1e-12);
  EXPECT_GT(tracker.covariance()(1, 1), 9.0 * 0.02);
}

/// Two walls along x: the scan cannot tell how far along, so the way along is odometry's.
TEST(PointToLine, KeepsThePredictionAlongACorridor) {
  std::vector<SurfacePoint> walls;
  for (int i = -100; i <= 100; ++i) {
    walls.push_back({{0.05 * i, 1.0}, {0.0, -1.0}});
    walls.push_back({{0.05 * i, -1.0}, {0.0, 1.0}});
  }
  LocalMap map(3, 0.05, 0.5);
  map.add(walls, RangeView({}), Pose2{});
  std::vector<SurfacePoint> seen(walls.begin() + 100, walls.end() - 100);
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.04, 0.04, 0.01).asDiagonal();
  const Pose2 predicted{0.21, 0.1, 0.05};
  const PointToLineMatch match = match_points(seen, map, predicted, covariance, {}, predicted);
  EXPECT_NEAR(match.T_map_base.x, predicted.x, 0.02);
  EXPECT_NEAR(match.T_map_base.y, 0.0, 1e-3);
  EXPECT_NEAR(match.T_map_base.theta, 0.0, 1e-3);
  EXPECT_NEAR(std::sqrt(match.covariance(0, 0)), 0.2, 0.02);
  EXPECT_LT(std::sqrt(match.covariance(1, 1)), 0.01);
}

}  // namespace
}  // namespace cogslam
