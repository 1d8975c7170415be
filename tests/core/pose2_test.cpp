#include "core/pose2.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "core/rng.hpp"

namespace cogslam {
namespace {

constexpr double kPi = std::numbers::pi;

Pose2 random_pose(Rng& rng) { return {rng.uniform(-20.0, 20.0), rng.uniform(-20.0, 20.0), rng.uniform(-kPi, kPi)}; }

void expect_same(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(angle_difference(a.theta, b.theta), 0.0, tolerance);
}

/// Slow twin of exp: walks the motion in many short straight steps, each halfway turned.
Pose2 walk(const Twist2& v, int steps) {
  Pose2 T;
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double middle = v.theta * (i + 0.5) * h;
    T.x += h * (std::cos(middle) * v.x - std::sin(middle) * v.y);
    T.y += h * (std::sin(middle) * v.x + std::cos(middle) * v.y);
  }
  T.theta = wrap_angle(v.theta);
  return T;
}

TEST(Pose2, ComposesAsSeenFromTheFirstFrame) {
  const Pose2 T_a_b{1.0, 2.0, kPi / 2}, T_b_c{3.0, 0.0, kPi / 2};
  expect_same(T_a_b * T_b_c, {1.0, 5.0, kPi}, 1e-15);
  const Eigen::Vector2d p_a = T_a_b * Eigen::Vector2d(1.0, 0.0);
  EXPECT_NEAR(p_a.x(), 1.0, 1e-15);
  EXPECT_NEAR(p_a.y(), 3.0, 1e-15);
}

TEST(Pose2, ObeysTheLawsOfAGroup) {
  Rng rng({.seed = 2, .purpose = Purpose::kWorld});
  for (int i = 0; i < 1000; ++i) {
    const Pose2 a = random_pose(rng), b = random_pose(rng), c = random_pose(rng);
    expect_same((a * b) * c, a * (b * c), 1e-12);
    expect_same(a * a.inverse(), {}, 1e-13);
    expect_same(a.inverse() * a, {}, 1e-13);
    expect_same((a * b).inverse(), b.inverse() * a.inverse(), 1e-12);
    const Eigen::Vector2d p(rng.uniform(-5, 5), rng.uniform(-5, 5));
    EXPECT_NEAR((((a * b) * p) - (a * (b * p))).norm(), 0.0, 1e-12);
  }
}

TEST(Pose2, KeepsHeadingsInTheHalfOpenTurn) {
  EXPECT_EQ((Pose2{0, 0, kPi}.inverse().theta), kPi);
  EXPECT_EQ((Pose2{0, 0, kPi} * Pose2{0, 0, kPi}).theta, 0.0);
  EXPECT_EQ(Pose2::exp({0, 0, -kPi}).theta, kPi);
}

TEST(Pose2, ExpEqualsManyShortSteps) {
  for (const double turn : {0.0, 1e-12, -1e-12, 0.9e-4, 1.1e-4, 0.3, -2.0, 3.1, -kPi + 1e-9, 7.0}) {
    expect_same(Pose2::exp({1.0, -2.0, turn}), walk({1.0, -2.0, turn}, 20000), 1e-7);
  }
}

TEST(Pose2, ExpIsSmoothWhereTheSeriesTakesOver) {
  const Twist2 below{1.0, 1.0, std::nextafter(1e-4, 0.0)}, above{1.0, 1.0, 1e-4};
  expect_same(Pose2::exp(below), Pose2::exp(above), 1e-15);
}

TEST(Pose2, LogUndoesExp) {
  Rng rng({.seed = 3, .purpose = Purpose::kWorld});
  for (const double turn : {0.0, 1e-12, -1e-12, 1e-5, 1e-3, 1.0, -3.0, kPi - 1e-12, -kPi + 1e-12, kPi}) {
    const Twist2 motion{rng.uniform(-3, 3), rng.uniform(-3, 3), turn};
    const Twist2 back = Pose2::exp(motion).log();
    EXPECT_NEAR(back.x, motion.x, 1e-14) << turn;
    EXPECT_NEAR(back.y, motion.y, 1e-14) << turn;
    EXPECT_EQ(back.theta, motion.theta);
  }
  for (int i = 0; i < 1000; ++i) {
    const Pose2 T = random_pose(rng);
    expect_same(Pose2::exp(T.log()), T, 1e-12);
  }
}

TEST(Pose2, InterpolationMeetsBothEndsAndTheMiddle) {
  Rng rng({.seed = 4, .purpose = Purpose::kWorld});
  for (int i = 0; i < 100; ++i) {
    const Pose2 a = random_pose(rng), b = random_pose(rng);
    expect_same(interpolate(a, b, 0.0), a, 1e-12);
    expect_same(interpolate(a, b, 1.0), b, 1e-12);
    const Pose2 half = interpolate(a, b, 0.5);
    expect_same(half * (a.inverse() * half), b, 1e-10);
  }
  expect_same(interpolate({0, 0, 3.0}, {0, 0, -3.0}, 0.5), {0, 0, kPi}, 1e-12);
}

TEST(Pose2, ComposedCovarianceEqualsThatOfSampledPoses) {
  Rng rng({.seed = 5, .purpose = Purpose::kWorld});
  const Pose2 T_a_b{1.0, 2.0, 0.7}, T_b_c{2.0, -0.5, -1.9};
  Eigen::Matrix3d root_a_b, root_b_c;
  root_a_b << 1, 0, 0, 0.4, 0.8, 0, -0.3, 0.5, 0.9;
  root_b_c << 0.7, 0, 0, -0.2, 1.1, 0, 0.6, 0.1, 0.5;
  constexpr double kSmall = 1e-3;  // the formula is of first order in the noise
  constexpr int kSamples = 200'000;
  const auto noise = [&](const Eigen::Matrix3d& root) {
    const double a = rng.normal(), b = rng.normal(), c = rng.normal();
    const Eigen::Vector3d n = kSmall * root * Eigen::Vector3d(a, b, c);
    return Pose2::exp({n.x(), n.y(), n.z()});
  };
  Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const Pose2 T_a_c = (T_a_b * noise(root_a_b)) * (T_b_c * noise(root_b_c));
    const Twist2 d = ((T_a_b * T_b_c).inverse() * T_a_c).log();
    const Eigen::Vector3d v(d.x / kSmall, d.y / kSmall, d.theta / kSmall);
    sampled += v * v.transpose() / kSamples;
  }
  const Eigen::Matrix3d expected =
      compose_covariance(root_a_b * root_a_b.transpose(), T_b_c, root_b_c * root_b_c.transpose());
  // Standard error of a variance is sqrt(2 / samples) of it, here 0.3 %; four of them, and the nonlinearity.
  EXPECT_LT((sampled - expected).norm(), 0.02 * expected.norm()) << sampled << "\n\n" << expected;
}

}  // namespace
}  // namespace cogslam
