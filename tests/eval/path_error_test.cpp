#include "eval/metrics/path_error.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Pose2> random_path(std::uint32_t seed, std::size_t size) {
  Rng rng({.seed = seed});
  std::vector<Pose2> path{{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-kPi, kPi)}};
  while (path.size() < size)
    path.push_back(path.back() * Pose2{rng.uniform(0, 0.3), rng.normal() * 0.05, rng.normal()});
  return path;
}

std::vector<Pose2> disturbed(std::vector<Pose2> path, std::uint32_t seed) {
  Rng rng({.seed = seed, .entity = 1});
  for (Pose2& T : path) T = T * Pose2{rng.normal() * 0.1, rng.normal() * 0.1, rng.normal() * 0.05};
  return path;
}

std::vector<Pose2> moved(const Pose2& T, std::vector<Pose2> path) {
  for (Pose2& pose : path) pose = T * pose;
  return path;
}

/// Root mean square distance after a turn, the best shift applied: what align_paths minimises, without its formula.
double rmse_after_turn(const std::vector<Pose2>& truth, const std::vector<Pose2>& estimate, double turn) {
  std::vector<Eigen::Vector2d> off;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    off.push_back(truth[i].position() - Pose2{0, 0, turn} * estimate[i].position());
    mean += off.back() / static_cast<double>(truth.size());
  }
  double sum = 0.0;
  for (const Eigen::Vector2d& o : off) sum += (o - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

TEST(PathError, IsTheMeanOfSquaresByHand) {
  const std::vector<Pose2> truth{{0, 0, 0}, {1, 0, 0}};
  const std::vector<Pose2> estimate{{0, 0, 0.2}, {1.3, 0.4, 0}};
  const auto error = path_error(truth, estimate);
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->position_mse, 0.25 / 2, 1e-15);
  EXPECT_NEAR(error->heading_mse, 0.04 / 2, 1e-15);
  EXPECT_NEAR(error->position_rmse(), std::sqrt(0.125), 1e-15);
  EXPECT_NEAR(error->heading_rmse(), std::sqrt(0.02), 1e-15);
}

TEST(PathError, WrapsTheHeading) {
  const std::vector<Pose2> truth{{0, 0, kPi - 0.05}}, estimate{{0, 0, -kPi + 0.05}};
  EXPECT_NEAR(path_error(truth, estimate)->heading_mse, 0.01, 1e-12);
}

TEST(PathError, DoesNotAlign) {
  const auto truth = random_path(1, 50);
  EXPECT_NEAR(path_error(truth, moved({3, 4, 0}, truth))->position_mse, 25.0, 1e-9);
}

TEST(PathError, IsZeroOnThePathItself) {
  const auto path = random_path(2, 50);
  EXPECT_EQ(path_error(path, path)->position_mse, 0.0);
  EXPECT_EQ(path_error(path, path)->heading_mse, 0.0);
  EXPECT_NEAR(*ate_rmse(path, path), 0.0, 1e-12);
  EXPECT_NEAR(relative_pose_error(path, path)->trans_rmse, 0.0, 1e-12);
}

TEST(PathError, OfNothingIsNotMeasured) {
  const std::vector<Pose2> none, one{{1, 2, 3}};
  EXPECT_FALSE(path_error(none, none));
  EXPECT_TRUE(path_error(one, one));
  EXPECT_FALSE(ate_rmse(none, none));
  EXPECT_FALSE(ate_rmse(one, one));
  EXPECT_FALSE(relative_pose_error(none, none));
  EXPECT_FALSE(relative_pose_error(one, one));
}

TEST(PathError, RejectsPathsOfDifferentLength) {
  const auto path = random_path(3, 5), longer = random_path(3, 6);
  EXPECT_THROW((void)path_error(path, longer), ContractViolation);
  EXPECT_THROW((void)ate_rmse(path, longer), ContractViolation);
  EXPECT_THROW((void)relative_pose_error(path, longer), ContractViolation);
}

TEST(AbsoluteTrajectoryError, IgnoresRigidMotionsOfTheEstimate) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const auto truth = random_path(seed, 60), estimate = disturbed(truth, seed);
    Rng rng({.seed = seed, .entity = 2});
    const Pose2 T{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-kPi, kPi)};
    EXPECT_NEAR(*ate_rmse(truth, moved(T, estimate)), *ate_rmse(truth, estimate), 1e-9) << "seed " << seed;
    EXPECT_NEAR(*ate_rmse(truth, moved(T, truth)), 0.0, 1e-9) << "seed " << seed;
  }
}

TEST(AbsoluteTrajectoryError, EqualsTheBestTurnFoundByTrying) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const auto truth = random_path(seed, 40), estimate = moved({1, 2, 2.5}, disturbed(truth, seed));
    double best = 1e9, best_turn = 0.0;
    for (double step = 0.01; step > 1e-7; step /= 10) {
      const double centre = best_turn;
      for (int i = -400; i <= 400; ++i) {
        const double rmse = rmse_after_turn(truth, estimate, centre + i * step);
        if (rmse < best) best = rmse, best_turn = centre + i * step;
      }
    }
    EXPECT_NEAR(*ate_rmse(truth, estimate), best, 1e-9) << "seed " << seed;
  }
}

TEST(RelativePoseError, TellsAScaleErrorPerMetre) {
  std::vector<Pose2> truth, estimate;
  for (int i = 0; i <= 40; ++i) {
    truth.push_back({0.25 * i, 0, 0});  // exact in binary: segments are of four steps
    estimate.push_back({0.25 * i * 1.1, 0, 0});
  }
  const auto error = relative_pose_error(truth, estimate, 1.0);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->segments, 37U);
  EXPECT_NEAR(error->trans_rmse, 0.1, 1e-12);
  EXPECT_NEAR(error->rot_rmse, 0.0, 1e-12);
}

TEST(RelativePoseError, EqualsTheObviousDoubleLoop) {
  const auto truth = random_path(7, 80), estimate = disturbed(truth, 7);
  double trans = 0.0, rot = 0.0;
  std::size_t segments = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    double travel = 0.0;
    for (std::size_t j = i + 1; j < truth.size(); ++j) {
      travel += (truth[j].position() - truth[j - 1].position()).norm();
      if (travel < 1.0) continue;
      const Pose2 e = (truth[i].inverse() * truth[j]).inverse() * (estimate[i].inverse() * estimate[j]);
      trans += e.x * e.x + e.y * e.y;
      rot += e.theta * e.theta;
      ++segments;
      break;
    }
  }
  const auto error = relative_pose_error(truth, estimate, 1.0);
  EXPECT_EQ(error->segments, segments);
  EXPECT_NEAR(error->trans_rmse, std::sqrt(trans / static_cast<double>(segments)), 1e-12);
  EXPECT_NEAR(error->rot_rmse, std::sqrt(rot / static_cast<double>(segments)), 1e-12);
}

TEST(RelativePoseError, IsNotMeasuredWhereNothingTravels) {
  const std::vector<Pose2> turning{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}};
  EXPECT_FALSE(relative_pose_error(turning, turning));
}

}  // namespace
}  // namespace cogslam
