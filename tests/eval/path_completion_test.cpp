#include "eval/metrics/path_completion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

std::vector<Pose2> drive(std::uint32_t seed, std::size_t size) {
  Rng rng({.seed = seed});
  std::vector<Pose2> path{{}};
  while (path.size() < size)
    path.push_back(path.back() * Pose2{rng.uniform(0, 0.3), rng.normal() * 0.05, rng.normal()});
  return path;
}

void expect_near(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(angle_difference(a.theta, b.theta), 0.0, tolerance);
}

TEST(PathCompletion, SharesOutWhatIsMissingByRecordIndex) {
  const std::vector<Pose2> odometry{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}};
  const std::vector<RegisteredPose> registered{{0, {0, 0, 0}}, {4, {4, 0.8, 0}}};
  const auto path = complete_path(odometry, registered);
  for (int i = 0; i <= 4; ++i) expect_near(path[static_cast<std::size_t>(i)], {1.0 * i, 0.2 * i, 0}, 1e-12);
  expect_near(path[5], {5, 0.8, 0}, 1e-12);  // after the last: odometry alone
}

TEST(PathCompletion, FollowsOdometryBeforeTheFirstRegisteredRecord) {
  const std::vector<Pose2> odometry{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<RegisteredPose> registered{{1, {5, 5, radians(90)}}};
  const auto path = complete_path(odometry, registered);
  expect_near(path[0], {5, 4, radians(90)}, 1e-12);
  EXPECT_EQ(path[1], (Pose2{5, 5, radians(90)}));
  expect_near(path[2], {5, 6, radians(90)}, 1e-12);
}

TEST(PathCompletion, KeepsRegisteredPosesExactly) {
  const auto odometry = drive(1, 40), other = drive(2, 40);
  std::vector<RegisteredPose> registered;
  for (std::size_t i = 3; i < 40; i += 4) registered.push_back({i, other[i]});
  const auto path = complete_path(odometry, registered);
  for (const RegisteredPose& r : registered) EXPECT_EQ(path[r.record], r.T_map_base);
}

TEST(PathCompletion, GivesTheTruthWhereOdometryIsRightUpToItsStart) {
  const auto odometry = drive(3, 50);
  const Pose2 T_map_odom{4, -2, 1};
  std::vector<RegisteredPose> registered;
  for (std::size_t i = 0; i < 50; i += 7) registered.push_back({i, T_map_odom * odometry[i]});
  const auto path = complete_path(odometry, registered);
  for (std::size_t i = 0; i < 50; ++i) expect_near(path[i], T_map_odom * odometry[i], 1e-9);
}

TEST(PathCompletion, RejectsUnorderedOrMissingRecords) {
  const auto odometry = drive(4, 5);
  const std::vector<RegisteredPose> none, twice{{1, {}}, {1, {}}}, beyond{{5, {}}};
  EXPECT_THROW((void)complete_path(odometry, none), ContractViolation);
  EXPECT_THROW((void)complete_path(odometry, twice), ContractViolation);
  EXPECT_THROW((void)complete_path(odometry, beyond), ContractViolation);
  EXPECT_THAT(complete_path({}, none), testing::IsEmpty());
}

}  // namespace
}  // namespace cogslam
