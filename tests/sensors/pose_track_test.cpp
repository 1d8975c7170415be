#include "sensors/pose_track.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "core/check.hpp"
#include "core/pose2.hpp"

namespace cogslam {
namespace {

Truth truth_at(std::int64_t ms, const Pose2& pose) {
  Truth t;
  t.time = {ms * 1'000'000};
  t.T_map_base = pose;
  t.wheel_angles = {static_cast<double>(ms), 0.0, 0.0, 0.0};
  return t;
}

TEST(PoseTrack, IsLinearBetweenTwoSteps) {
  PoseTrack track({100'000'000});
  track.push(truth_at(0, {1.0, 2.0, 0.2}));
  track.push(truth_at(1, {2.0, 0.0, 0.4}));
  const Truth t = track.at({250'000});
  EXPECT_EQ(t.time, Time{250'000});
  EXPECT_NEAR(t.T_map_base.x, 1.25, 1e-12);
  EXPECT_NEAR(t.T_map_base.y, 1.5, 1e-12);
  EXPECT_NEAR(t.T_map_base.theta, 0.25, 1e-12);
  EXPECT_NEAR(t.wheel_angles[0], 0.25, 1e-12);
}

TEST(PoseTrack, TurnsTheShortWayAcrossPi) {
  PoseTrack track({100'000'000});
  track.push(truth_at(0, {0.0, 0.0, std::numbers::pi - 0.01}));
  track.push(truth_at(1, {0.0, 0.0, -std::numbers::pi + 0.03}));
  EXPECT_NEAR(track.at({500'000}).T_map_base.theta, -std::numbers::pi + 0.01, 1e-12);
}

TEST(PoseTrack, GivesBackTheStepsThemselvesToTheBit) {
  PoseTrack track({100'000'000});
  for (int ms = 0; ms <= 50; ++ms) track.push(truth_at(ms, {0.1 * ms, 0.3, 0.01 * ms}));
  for (int ms = 0; ms <= 50; ++ms) EXPECT_EQ(track.at({ms * 1'000'000}).T_map_base, (Pose2{0.1 * ms, 0.3, 0.01 * ms}));
}

TEST(PoseTrack, StaysWithinAMicrometreOfTheArc) {
  PoseTrack track({100'000'000});
  const Twist2 twist{1.0, 0.0, 2.0};
  for (int ms = 0; ms <= 20; ++ms) track.push(truth_at(ms, Pose2::exp(0.001 * ms * twist)));
  for (int us = 0; us <= 20000; us += 7) {
    const Pose2 arc = Pose2::exp(1e-6 * us * twist);
    EXPECT_LT((track.at({us * 1000}).T_map_base.position() - arc.position()).norm(), 1e-6);
  }
}

TEST(PoseTrack, RemembersItsMemoryAndForgetsTheRest) {
  PoseTrack track({10'000'000});
  for (int ms = 0; ms <= 100; ++ms) {
    track.push(truth_at(ms, {}));
    EXPECT_LE(track.oldest(), Time{std::max(0, ms - 10) * 1'000'000});
  }
  EXPECT_EQ(track.oldest(), Time{90'000'000});
  EXPECT_THROW(static_cast<void>(track.at({89'000'000})), ContractViolation);
  EXPECT_THROW(static_cast<void>(track.at({100'000'001})), ContractViolation);
  EXPECT_THROW(track.push(truth_at(100, {})), ContractViolation);
}

}  // namespace
}  // namespace cogslam
