#include "slam/match/scan_matcher.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "tests/support/mapped_room.hpp"
#include "tests/support/pose_scores.hpp"

namespace cogslam {
namespace {

Eigen::Vector3d small_motion_between(const Pose2& from, const Pose2& to) {
  const Twist2 v = (from.inverse() * to).log();
  return {v.x, v.y, v.theta};
}

Eigen::Matrix3d diagonal(double x, double y, double theta) {
  return Eigen::Vector3d(x * x, y * y, theta * theta).asDiagonal();
}

TEST(MatchScan, FindsTheTruePoseFromAnyStartWithinItsWindow) {
  constexpr double kCell = 0.05;
  const Grid<float> room = mapped_cornered_room(kCell);
  // So many beams that the motion's pull towards the prediction is below a millimetre.
  ScanLikelihood likelihood({.beams = 360, .effective_beams = 360.0}, kCell);
  likelihood.look_at(room);
  const Eigen::Matrix3d motion = diagonal(0.08, 0.08, 0.04);
  for (std::uint32_t round = 0; round < 40; ++round) {
    Rng rng({.seed = 50, .purpose = Purpose::kWorld, .entity = round});
    const Pose2 truth{rng.uniform(-1.5, 0.3), rng.uniform(-1.4, 0.0), rng.uniform(-3.0, 3.0)};
    const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), truth, 720));
    const Pose2 predicted =
        truth * Pose2::exp({rng.uniform(-0.12, 0.12), rng.uniform(-0.12, 0.12), rng.uniform(-0.06, 0.06)});
    const ScanMatch match = match_scan(field_score(likelihood, probes), predicted, motion, ScanMatcherConfig{});
    EXPECT_LE((match.T_map_base.position() - truth.position()).norm(), 0.01) << "round " << round;
    EXPECT_LE(std::abs(wrap_angle(match.T_map_base.theta - truth.theta)), 0.3 * std::numbers::pi / 180.0)
        << "round " << round;
  }
}

TEST(MatchScan, ReportsItsValueAtTheMode) {
  const Grid<float> room = mapped_cornered_room(0.1);
  ScanLikelihood likelihood(ScanLikelihoodConfig{}, 0.1);
  likelihood.look_at(room);
  const Pose2 truth{-0.5, -0.6, 0.3};
  const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), truth, 360));
  int calls = 0;
  const PoseScore score{[&](const Pose2& pose) {
                          ++calls;
                          return likelihood.field_log_likelihood(probes, pose);
                        },
                        [&](const Pose2& pose) {
                          ++calls;
                          return likelihood.field_fit(probes, pose);
                        }};
  Eigen::Matrix3d motion = diagonal(0.05, 0.03, 0.02);
  motion(0, 1) = motion(1, 0) = 0.0005;
  const Pose2 predicted = truth * Pose2::exp({0.04, -0.03, 0.02});
  const ScanMatch match = match_scan(score, predicted, motion, ScanMatcherConfig{});
  EXPECT_EQ(match.evaluations, calls);
  EXPECT_TRUE(match.converged);
  const Eigen::Vector3d v = small_motion_between(predicted, match.T_map_base);
  EXPECT_NEAR(match.log_posterior, score.value(match.T_map_base) - 0.5 * v.dot(motion.inverse() * v), 1e-6);
  EXPECT_GE(match.log_posterior, score.value(predicted));
}

/// Everything is known where the score is a Gaussian: the mode and the spread are those of the product of two
/// Gaussians.
TEST(MatchScan, EqualsTheProductOfTwoGaussians) {
  Eigen::Matrix3d seen;  // information of the scan
  seen << 900.0, 200.0, 300.0, 200.0, 2500.0, -400.0, 300.0, -400.0, 9000.0;
  const Eigen::Matrix3d motion = diagonal(0.06, 0.05, 0.03);
  const Pose2 predicted{2.0, -1.0, 0.7};
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(0.03, 0.0, 0.0), Eigen::Vector3d(0.03, -0.05, 0.02), Eigen::Vector3d(-0.04, 0.02, -0.03)}) {
    const auto score = [&](const Pose2& pose) {
      const Eigen::Vector3d e = small_motion_between(predicted, pose) - offset;
      return -0.5 * e.dot(seen * e);
    };
    const ScanMatch match = match_scan(smooth_score(score), predicted, motion, ScanMatcherConfig{});
    const Eigen::Matrix3d covariance = (seen + motion.inverse()).inverse();
    const Eigen::Vector3d mode = covariance * seen * offset;
    EXPECT_TRUE(match.converged);
    EXPECT_NEAR((small_motion_between(predicted, match.T_map_base) - mode).norm(), 0.0, 1e-3);
    // To 5 %: the small motion after the mode differs from that after the prediction in second order.
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const double scale = std::sqrt(covariance(a, a) * covariance(b, b));
        EXPECT_NEAR(match.covariance(a, b), covariance(a, b), 0.05 * scale) << a << " " << b;
      }
    }
    const double best =
        score(predicted * Pose2::exp({mode.x(), mode.y(), mode.z()})) - 0.5 * mode.dot(motion.inverse() * mode);
    EXPECT_NEAR(match.log_posterior, best, 1e-2);
  }
}

TEST(MatchScan, StaysAtThePredictionWhereTheScoreIsFlat) {
  Eigen::Matrix3d motion = diagonal(0.1, 0.05, 0.03);
  motion(0, 2) = motion(2, 0) = 0.001;
  const Pose2 predicted{1.0, 2.0, -3.0};
  const ScanMatch match =
      match_scan(smooth_score([](const Pose2&) { return -7.5; }), predicted, motion, ScanMatcherConfig{});
  EXPECT_TRUE(match.converged);
  EXPECT_NEAR(small_motion_between(predicted, match.T_map_base).norm(), 0.0, 1e-9);
  EXPECT_NEAR(match.log_posterior, -7.5, 1e-9);
  EXPECT_TRUE(match.covariance.isApprox(motion, 1e-6));
}

TEST(MatchScan, KeepsTheMotionsSpreadAlongACorridor) {
  const std::vector<Wall> corridor{{{-40.0, -1.03}, {40.0, -1.03}}, {{40.0, 0.97}, {-40.0, 0.97}}};
  std::vector<Pose2> poses;
  for (double x = -6.0; x <= 6.0; x += 0.5) poses.push_back({x, 0.0, 0.0});
  const Grid<float> map = mapped(corridor, poses, Rectangle{{-12.0, -2.0}, {12.0, 2.0}}, 0.1);
  ScanLikelihood likelihood(ScanLikelihoodConfig{}, 0.1);
  likelihood.look_at(map);
  // Only what lies abeam: sight lines along the corridor are as long as the range allows.
  std::vector<Beam> probes = likelihood.probes_of(clean_sweep(corridor, Pose2{}, 720));
  std::erase_if(probes, [](const Beam& beam) { return std::abs(beam.end.x()) > 3.0; });
  const Eigen::Matrix3d motion = diagonal(0.1, 0.1, 0.05);
  const ScanMatch match =
      match_scan(field_score(likelihood, probes), Pose2{0.02, 0.06, 0.02}, motion, ScanMatcherConfig{});
  EXPECT_NEAR(match.T_map_base.y, 0.0, 0.03);
  EXPECT_NEAR(match.T_map_base.theta, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(match.covariance(0, 0)), 0.1, 0.03);
  EXPECT_LT(std::sqrt(match.covariance(1, 1)), 0.05);
  EXPECT_LT(std::sqrt(match.covariance(2, 2)), 0.025);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(match.covariance).eigenvalues().minCoeff(), 0.0);
}

TEST(MatchScan, StatesHowFarItMayTakeAPoint) {
  const ScanMatcherConfig config{.window_sigmas = 2.0, .coarse_step = 0.1, .coarse_steps_max = 10};
  EXPECT_NEAR(farthest_move(diagonal(0.03, 0.04, 0.01), 20.0, config), 3.0 * (0.05 + 20.0 * 0.01), 1e-12);
  // However wide the spread, the search ends at its limit: 1 m, and what moves a point at 4 m by as much.
  const double most = farthest_move(diagonal(500.0, 500.0, 1.0), 20.0, config);
  EXPECT_GT(most, std::sqrt(2.0) + 20.0 * 0.25);
  EXPECT_LT(most, 2.0 * (std::sqrt(2.0) + 20.0 * 0.25));
}

}  // namespace
}  // namespace cogslam
