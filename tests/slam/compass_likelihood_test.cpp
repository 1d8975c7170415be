#include "slam/weight/compass_likelihood.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <numbers>

#include "core/angle.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

constexpr double kPi = std::numbers::pi;

Rng test_rng(std::uint32_t entity) { return Rng({.seed = 47, .purpose = Purpose::kCompassNoise, .entity = entity}); }

/// Batch twin: log of the joint density of k errors that share one random bias, N(0, noise^2 I + bias^2 1 1^T).
double joint_log_density(const std::vector<double>& errors, const CompassModel& model) {
  const auto k = static_cast<Eigen::Index>(errors.size());
  const Eigen::VectorXd e = Eigen::Map<const Eigen::VectorXd>(errors.data(), k);
  const Eigen::MatrixXd covariance = model.noise * model.noise * Eigen::MatrixXd::Identity(k, k) +
                                     model.bias_sigma * model.bias_sigma * Eigen::MatrixXd::Ones(k, k);
  const Eigen::LDLT<Eigen::MatrixXd> factor(covariance);
  return -0.5 *
         (e.dot(factor.solve(e)) + factor.vectorD().array().log().sum() + static_cast<double>(k) * std::log(2.0 * kPi));
}

CompassBias prior_of(const CompassModel& model) { return {0.0, model.bias_sigma * model.bias_sigma}; }

TEST(CompassLikelihood, AddsUpToTheJointEvidenceOfABiasThatNobodyKnows) {
  for (std::uint32_t round = 0; round < 100; ++round) {
    Rng rng = test_rng(round);
    const CompassModel model{.noise = rng.uniform(0.01, 0.1), .bias_sigma = rng.uniform(0.0, 0.1)};
    const double truth = model.bias_sigma * rng.normal();
    CompassBias bias = prior_of(model);
    double sum = 0.0;
    std::vector<double> errors;
    for (std::uint32_t i = 1 + rng.below(30); i > 0; --i) {
      // Headings all round, so that the sum of heading and error often crosses +-pi.
      const double theta = rng.uniform(-kPi, kPi), error = truth + model.noise * rng.normal();
      errors.push_back(error);
      sum += compass_log_likelihood(wrap_angle(theta + error), theta, model, bias);
      ASSERT_NEAR(sum, joint_log_density(errors, model), 1e-8);
    }
  }
}

TEST(CompassLikelihood, TakesTheShortWayRound) {
  const CompassModel model{.noise = 0.05, .bias_sigma = 0.05};
  CompassBias across = prior_of(model), plain = prior_of(model);
  EXPECT_NEAR(compass_log_likelihood(-kPi + 0.01, kPi - 0.02, model, across),
              compass_log_likelihood(0.03, 0.0, model, plain), 1e-10);
  EXPECT_NEAR(across.mean, plain.mean, 1e-12);
  EXPECT_GT(across.mean, 0.0);
}

TEST(CompassLikelihood, LearnsTheBias) {
  const CompassModel model{.noise = 0.035, .bias_sigma = 0.03};
  CompassBias bias = prior_of(model);
  Rng rng = test_rng(1000);
  constexpr int kHeadings = 2000;
  for (int i = 0; i < kHeadings; ++i) {
    const double theta = rng.uniform(-kPi, kPi);
    compass_log_likelihood(wrap_angle(theta + 0.052 + model.noise * rng.normal()), theta, model, bias);
  }
  const double expected_variance = 1.0 / (1.0 / (0.03 * 0.03) + kHeadings / (0.035 * 0.035));
  EXPECT_NEAR(bias.variance, expected_variance, 1e-12);
  EXPECT_NEAR(bias.mean, 0.052, 4.0 * std::sqrt(expected_variance));
}

TEST(CompassLikelihood, NeverLearnsABiasThatIsKnownToBeNone) {
  const CompassModel model{.noise = 0.035, .bias_sigma = 0.0};
  CompassBias bias = prior_of(model);
  for (int i = 0; i < 10; ++i) compass_log_likelihood(0.3, 0.0, model, bias);
  EXPECT_EQ(bias.mean, 0.0);
  EXPECT_EQ(bias.variance, 0.0);
}

TEST(CompassLikelihood, BelievesNoHeadingFarBeyondItsNoise) {
  const CompassModel model{.noise = 0.03, .bias_sigma = 0.04};
  const CompassBias prior{0.01, 0.0016};  // 0.05 rad with the noise
  CompassBias at_gate = prior, beyond = prior, far = prior;
  const double inside = compass_log_likelihood(0.01 + 4.999 * 0.05, 0.0, model, at_gate);
  const double outside = compass_log_likelihood(0.01 + 5.001 * 0.05, 0.0, model, beyond);
  EXPECT_NEAR(inside, outside, 0.01);
  EXPECT_EQ(compass_log_likelihood(2.0, 0.0, model, far), outside);
  EXPECT_GT(at_gate.mean, prior.mean);
  EXPECT_EQ(far.mean, prior.mean);
  EXPECT_EQ(far.variance, prior.variance);
  EXPECT_NEAR(compass_sigmas(0.01 - 0.15, 0.0, model, prior), 3.0, 1e-12);
}

}  // namespace
}  // namespace cogslam
