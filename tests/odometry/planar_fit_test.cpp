#include "slam/odometry/planar_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <vector>

#include "core/rng.hpp"

namespace cogslam {
namespace {

constexpr double kNoise = 0.0001;  // [m], a tenth of a pixel

Pose2 random_motion(Rng& rng) { return {rng.uniform(-0.02, 0.02), rng.uniform(-0.02, 0.02), rng.uniform(-0.05, 0.05)}; }

std::vector<FloorPair> pairs_of(const Pose2& T_before_now, int count, double noise, Rng& rng) {
  std::vector<FloorPair> pairs;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d now(rng.uniform(-0.13, 0.13), rng.uniform(-0.17, 0.17));
    pairs.push_back({T_before_now * now + noise * Eigen::Vector2d(rng.normal(), rng.normal()), now});
  }
  return pairs;
}

Eigen::Vector3d error_of(const PlanarFit& fit, const Pose2& truth) {
  const Twist2 e = (fit.T_before_now.inverse() * truth).log();
  return {e.x, e.y, e.theta};
}

TEST(PlanarFit, FindsExactMotions) {
  Rng rng({.seed = 1, .purpose = Purpose::kWorld});
  for (int i = 0; i < 200; ++i) {
    const Pose2 truth = random_motion(rng);
    const auto fit = fit_planar_motion(pairs_of(truth, 30, 0.0, rng), {});
    ASSERT_TRUE(fit && fit->converged);
    EXPECT_EQ(fit->inliers, 30);
    EXPECT_NEAR(error_of(*fit, truth).norm(), 0.0, 1e-7);
  }
}

TEST(PlanarFit, IgnoresPairsThatWentAstray) {
  Rng rng({.seed = 2, .purpose = Purpose::kWorld});
  for (int i = 0; i < 200; ++i) {
    const Pose2 truth = random_motion(rng);
    std::vector<FloorPair> pairs = pairs_of(truth, 60, kNoise, rng);
    for (std::size_t k = 0; k < pairs.size(); k += 3)
      pairs[k].before += Eigen::Vector2d(rng.uniform(0.003, 0.02), 0.005);
    const auto fit = fit_planar_motion(pairs, {});
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->inliers, 40);
    EXPECT_LT(error_of(*fit, truth).head<2>().norm(), 6.0 * kNoise / std::sqrt(40.0));
  }
}

TEST(PlanarFit, CovarianceMatchesTheErrors) {
  // Mean of e^T C^-1 e: 3 degrees of freedom, and s^2 from 2 n - 3 = 77 residuals lifts it to 3 * 77 / 75 = 3.08.
  Rng rng({.seed = 3, .purpose = Purpose::kWorld});
  double sum = 0.0;
  constexpr int kTrials = 2000;
  for (int i = 0; i < kTrials; ++i) {
    const Pose2 truth = random_motion(rng);
    const auto fit = fit_planar_motion(pairs_of(truth, 40, kNoise, rng), {});
    ASSERT_TRUE(fit);
    const Eigen::Vector3d error = error_of(*fit, truth);
    sum += error.dot(fit->covariance.ldlt().solve(error)) / kTrials;
  }
  // The statistic's own deviation is about sqrt(2 * 3 / 2000) = 0.055. Huber's loss costs a few per cent of efficiency.
  EXPECT_NEAR(sum, 3.1, 0.25);
}

TEST(PlanarFit, SaysNothingWhereTooFewPairsAgree) {
  Rng rng({.seed = 4, .purpose = Purpose::kWorld});
  EXPECT_FALSE(fit_planar_motion({}, {}));
  EXPECT_FALSE(fit_planar_motion(pairs_of({}, 2, 0.0, rng), {}));
  std::vector<FloorPair> scattered;
  for (int i = 0; i < 40; ++i) {
    scattered.push_back(
        {{rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1)}, {rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1)}});
  }
  EXPECT_FALSE(fit_planar_motion(scattered, {.min_inliers = 10}));
}

}  // namespace
}  // namespace cogslam
