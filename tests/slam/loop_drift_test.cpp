#include "slam/loop_drift.hpp"

#include <gmock/gmock.h>

#include "core/rng.hpp"
#include "slam/waiting_scans.hpp"
#include "tests/support/statistics.hpp"

namespace cogslam {
namespace {

const Pose2 kStep{0.5, 0.0, 0.1};

TEST(LoopDrift, KeepsTheDriftUntilTheOldMapIsInSight) {
  LoopDrift drift({});
  for (int i = 0; i < 50; ++i) {
    drift.move(kStep);
    drift.look(false);
    EXPECT_TRUE(drift.released().isZero());
    EXPECT_FALSE(drift.closes_loop());
  }
  drift.move(kStep);
  drift.look(true);
  EXPECT_TRUE(drift.closes_loop());
  drift.move(kStep);
  drift.look(true);  // released once; what came since is small
  EXPECT_GT(drift.released()(0, 0), 0.0);
  EXPECT_FALSE(drift.closes_loop());
}

/// Slow twin: many paths whose every step errs by the stated noise; the spread of where they end.
TEST(LoopDrift, ReleasesTheCovarianceOfTheWholeWay) {
  const LoopConfig config{.drift_position = 0.03, .drift_heading = 0.02};
  LoopDrift drift(config);
  const int steps = 40;
  for (int i = 0; i < steps; ++i) {
    drift.move(kStep);
    drift.look(false);
  }
  drift.move({});  // no travel, no more drift
  drift.look(true);

  Pose2 straight;
  for (int i = 0; i < steps; ++i) straight = straight * kStep;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const int paths = 20000;
  Rng rng({.seed = 5, .purpose = Purpose::kWorld});
  for (int p = 0; p < paths; ++p) {
    Pose2 end;
    const double root = std::sqrt(0.5);  // of a step's travel
    for (int i = 0; i < steps; ++i) {
      end = end * kStep *
            Pose2::exp({root * 0.03 * rng.normal(), root * 0.03 * rng.normal(), root * 0.02 * rng.normal()});
    }
    const Twist2 away = (straight.inverse() * end).log();
    const Eigen::Vector3d v(away.x, away.y, away.theta);
    sum += v * v.transpose() / paths;
  }
  EXPECT_TRUE(drift.released().isApprox(sum, 0.04)) << drift.released() << "\n\n" << sum;
}

TEST(LoopDrift, KeepsTheKnownShareWhereTheOldMapIsInSight) {
  const LoopConfig config{.drift_position = 0.1, .drift_heading = 0.1, .known_share = 0.3};
  LoopDrift drift(config);
  for (int i = 0; i < 3; ++i) {
    drift.move({2.0, 0.0, 0.0});
    drift.look(true);
  }
  drift.move({});  // the step released here
  drift.look(true);
  EXPECT_NEAR(drift.released()(0, 0), 0.3 * 0.01 * 2.0, 1e-12);
  EXPECT_NEAR(drift.released()(2, 2), 0.3 * 0.01 * 2.0, 1e-12);
}

TEST(LoopDrift, CallsAPlaceOldAfterEnoughTravelNotDistance) {
  LoopDrift drift({.least_way = 10.0});
  for (int i = 0; i < 10; ++i) drift.move({i % 2 == 0 ? 2.0 : -2.0, 0.0, 0.0});  // to and fro: 20 m, nowhere
  EXPECT_TRUE(drift.is_old(0));
  EXPECT_TRUE(drift.is_old(4));
  EXPECT_FALSE(drift.is_old(5));
  EXPECT_FALSE(drift.is_old(9));
}

TEST(LoopDrift, SeesTheOldMapNearOldPosesOnly) {
  LoopDrift drift({.sight = 3.0, .least_way = 10.0});
  std::vector<RegisteredPose> path;
  for (std::size_t i = 0; i < 10; ++i) {  // along x, 2 m apart: old are those up to x = 8
    drift.move({i == 0 ? 0.0 : 2.0, 0.0, 0.0});
    path.push_back({i, {2.0 * static_cast<double>(i), 0.0, 0.0}});
  }
  EXPECT_TRUE(drift.old_map_in_sight({8.0, 2.9, 0.0}, path));
  EXPECT_FALSE(drift.old_map_in_sight({8.0, 3.1, 0.0}, path));
  EXPECT_TRUE(drift.old_map_in_sight({10.9, 0.0, 0.0}, path));
  EXPECT_FALSE(drift.old_map_in_sight({11.1, 0.0, 0.0}, path));  // near x = 10, which is not old
  EXPECT_TRUE(drift.old_map_in_sight({-2.0, 0.0, 0.0}, path));
  EXPECT_FALSE(drift.old_map_in_sight({0.0, 0.0, 0.0}, std::span(path).first(0)));
}

TEST(WaitingScans, LetTheOldestGoOnceMoreThanTheCountAreThere) {
  WaitingScans waiting(3);
  for (std::uint64_t i = 0; i < 10; ++i) {
    waiting.add(i, {.sequence = i});
    EXPECT_EQ(waiting.ripe(), i >= 3);
    EXPECT_EQ(waiting.size(), std::min<std::size_t>(i + 1, 3));
    if (waiting.ripe()) EXPECT_EQ(waiting.oldest().reading.sequence, i - 3);
    for (std::size_t k = 0; k < waiting.size(); ++k) EXPECT_EQ(waiting[k].record, i + 1 + k - waiting.size());
  }
}

TEST(WaitingScans, DoNotWaitWhereNoneShall) {
  WaitingScans waiting(0);
  for (std::uint64_t i = 0; i < 5; ++i) {
    waiting.add(i, {.sequence = i});
    EXPECT_TRUE(waiting.ripe());
    EXPECT_EQ(waiting.oldest().reading.sequence, i);
    EXPECT_EQ(waiting.size(), 0);
  }
}

}  // namespace
}  // namespace cogslam
