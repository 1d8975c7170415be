#include "slam/motion_model.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "slam/registration.hpp"

namespace cogslam {
namespace {

Eigen::Matrix3d random_covariance(Rng& rng, double sigma) {
  Eigen::Matrix3d root;
  for (int i = 0; i < 9; ++i) root(i / 3, i % 3) = rng.normal();
  return sigma * sigma * root * root.transpose() / 3.0;
}

MotionIncrement random_increment(Rng& rng, double sigma) {
  return {.T_before_now = {rng.uniform(-0.3, 0.5), rng.uniform(-0.3, 0.3), rng.uniform(-0.6, 0.6)},
          .covariance = random_covariance(rng, sigma)};
}

Eigen::Vector3d small_motion_between(const Pose2& from, const Pose2& to) {
  const Twist2 v = (from.inverse() * to).log();
  return {v.x, v.y, v.theta};
}

/// Mean and covariance of the small motions from `mean` to the poses that `draw` gives.
template <class Draw>
std::pair<Eigen::Vector3d, Eigen::Matrix3d> sampled_moments(const Pose2& mean, int count, Draw&& draw) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d v = small_motion_between(mean, draw());
    sum += v;
    squares += v * v.transpose();
  }
  const Eigen::Vector3d m = sum / count;
  return {m, squares / count - m * m.transpose()};
}

Rng test_rng(std::uint32_t entity) { return Rng({.seed = 46, .purpose = Purpose::kMotionSample, .entity = entity}); }

/// Of the sampled covariance of n draws: each entry has a standard error of at most sigma_a sigma_b sqrt(2 / n).
void expect_near(const Eigen::Matrix3d& sampled, const Eigen::Matrix3d& expected, double relative) {
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const double scale = std::sqrt(expected(a, a) * expected(b, b));
      EXPECT_NEAR(sampled(a, b), expected(a, b), relative * scale) << a << " " << b;
    }
  }
}

TEST(MotionModel, DrawsPosesWithItsOwnMeanAndCovariance) {
  constexpr int kDraws = 20000;
  Rng rng = test_rng(0);
  MotionModel model({.inflation = 1.5, .least_sigma_position = 0.01, .least_sigma_heading = 0.02});
  for (int i = 0; i < 3; ++i) model.add(random_increment(rng, 0.02));
  const Pose2 T_map_last{3.0, -2.0, 2.5};
  const auto [mean, covariance] =
      sampled_moments(T_map_last * model.T_last_now(), kDraws, [&] { return model.sample(T_map_last, rng); });
  const Eigen::Matrix3d expected = model.covariance();
  // Four standard errors.
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(mean[a], 0.0, 4.0 * std::sqrt(expected(a, a) / kDraws));
  expect_near(covariance, expected, 4.0 * std::sqrt(2.0 / kDraws));
}

TEST(MotionModel, JoinsManyIncrementsAsIfEachWereDrawn) {
  constexpr int kDraws = 20000;
  for (std::uint32_t round = 0; round < 3; ++round) {
    Rng rng = test_rng(1 + round);
    std::vector<MotionIncrement> increments;
    MotionModel model({.inflation = 1.0, .least_sigma_position = 1e-9, .least_sigma_heading = 1e-9});
    for (int i = 0; i < 6; ++i) {
      increments.push_back(random_increment(rng, 0.005));
      model.add(increments.back());
    }
    Pose2 mean;
    for (const MotionIncrement& motion : increments) mean = mean * motion.T_before_now;
    EXPECT_NEAR(small_motion_between(model.T_last_now(), mean).norm(), 0.0, 1e-12);
    const auto [bias, covariance] = sampled_moments(mean, kDraws, [&] {
      Pose2 pose;
      for (const MotionIncrement& motion : increments) {
        pose = pose * sample_pose(motion.T_before_now, motion.covariance, rng);
      }
      return pose;
    });
    // Four standard errors, and what first order leaves out at 0.005.
    expect_near(covariance, model.covariance(), 4.0 * std::sqrt(2.0 / kDraws) + 0.005);
  }
}

TEST(MotionModel, InflatesStandardDeviationsAndAddsItsLeastSigmas) {
  MotionModel model({.inflation = 2.0, .least_sigma_position = 0.1, .least_sigma_heading = 0.2});
  const Eigen::Matrix3d given = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  model.add({.covariance = given});
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.05, 0.17, 0.40).asDiagonal();
  EXPECT_TRUE(model.covariance().isApprox(expected, 1e-12));
}

TEST(MotionModel, IsAlwaysPositiveDefinite) {
  for (std::uint32_t round = 0; round < 200; ++round) {
    Rng rng = test_rng(100 + round);
    MotionModel model(MotionModelConfig{});
    for (std::uint32_t i = rng.below(50); i > 0; --i) {
      MotionIncrement motion = random_increment(rng, 0.05);
      if (rng.below(3) == 0) motion.covariance.setZero();
      if (rng.below(3) == 0)
        motion.covariance = motion.covariance.row(0).transpose() * motion.covariance.row(0);  // rank 1
      model.add(motion);
    }
    const Eigen::Matrix3d covariance = model.covariance();
    ASSERT_EQ(Eigen::LLT<Eigen::Matrix3d>(covariance).info(), Eigen::Success);
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().minCoeff(), 1e-7);
  }
}

TEST(MotionModel, StartsAnew) {
  MotionModel model(MotionModelConfig{});
  const Eigen::Matrix3d least = model.covariance();
  Rng rng = test_rng(300);
  model.add(random_increment(rng, 0.1));
  EXPECT_FALSE(model.covariance().isApprox(least));
  model.restart();
  EXPECT_EQ(model.T_last_now(), Pose2{});
  EXPECT_EQ(model.covariance(), least);
}

TEST(RegistrationConfig, IsDueAfterTravelOrTurning) {
  const RegistrationConfig rule{.distance = 0.1, .turn = 0.2};
  EXPECT_FALSE(rule.due({}));
  EXPECT_FALSE(rule.due({0.06, 0.06, 0.19}));
  EXPECT_TRUE(rule.due({-0.08, 0.07, 0.0}));
  EXPECT_TRUE(rule.due({0.0, 0.0, -0.2}));
}

}  // namespace
}  // namespace cogslam
