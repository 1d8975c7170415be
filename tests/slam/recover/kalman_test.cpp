#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>

#include "core/check.hpp"
#include "slam/recover/kalman_prior.hpp"
#include "slam/recover/recovery.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random_measurements.hpp"
#include "tests/support/slow_recover.hpp"

namespace cogslam {
namespace {

using namespace test;
using Reading = KalmanCsP::Reading;

constexpr double kQ = 1e-4;

MatrixMap reference_rows() {
  std::vector<double> rows = golden::read("golden/H128_rows_m96.csv");
  rows.resize(64 * 128);
  return {std::move(rows), 64, 128};
}

KalmanCsP with_passes(Reading reading, int passes) {
  KalmanCsP parameters = KalmanCsP::of(reading);
  parameters.tau = passes + 1;
  return parameters;
}

Eigen::MatrixXd whole(const KalmanEstimate& estimate) { return estimate.covariance.selfadjointView<Eigen::Lower>(); }

Eigen::VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

TEST(KalmanCs, EqualsTheReference) {
  SKIP_WITHOUT_GOLDEN();
  MatrixMap H = reference_rows();
  const std::vector<double> y = golden::read("golden/y_m64.csv");
  for (const int passes : {0, 1, 10, 999, 1000}) {
    KalmanCs parameters;
    parameters.tau = passes + 1;
    const std::string name = passes == 0 ? "kf_only" : "csekf_" + std::to_string(passes) + "it";
    const Recovered result = recover(parameters, H, y);
    EXPECT_LE(largest_difference(result.x, golden::read("golden/c_m64_" + name + ".csv")), passes < 11 ? 1e-12 : 1e-9)
        << name;
    EXPECT_EQ(result.iterations, passes);
  }
}

TEST(KalmanCsP, EqualsTheReferenceWhileRoundingAllows) {
  SKIP_WITHOUT_GOLDEN();
  MatrixMap H = reference_rows();
  const std::vector<double> y = golden::read("golden/y_m64.csv");
  const auto difference = [&](Reading reading, const std::string& name, int passes) {
    return largest_difference(
        recover(with_passes(reading, passes), H, y).x,
        golden::read("golden/c_m64_csekfp_" + name + "_p0.4_" + std::to_string(passes) + "it.csv"));
  };
  EXPECT_LE(difference(Reading::kAsPrinted, "R1", 1), 1e-12);
  EXPECT_LE(difference(Reading::kTrueGradient, "R2", 1), 1e-12);
  EXPECT_LE(difference(Reading::kPowerSum, "R3", 1), 1e-12);
  EXPECT_LE(difference(Reading::kAsPrinted, "R1", 10), 1e-9);
  EXPECT_LE(difference(Reading::kPowerSum, "R3", 10), 1e-9);
}

TEST(Kalman, FirstStepIsAShrunkTranspose) {
  Rng rng = rng_of(1);
  const Eigen::MatrixXd H = orthogonal_matrix(12, rng).topRows(5);
  MatrixMap map = map_of(H);
  const std::vector<double> y = normal_vector(5, rng);
  const KalmanEstimate estimate = kalman_step(map, y, kQ, 0.0);
  EXPECT_LE((estimate.mean - H.transpose() * vector_of(y) / (1.0 + kQ)).norm(), 1e-13);
  const Eigen::MatrixXd expected = Eigen::MatrixXd::Identity(12, 12) - H.transpose() * H / (1.0 + kQ);
  EXPECT_LE((whole(estimate) - expected).norm(), 1e-13);
}

TEST(Kalman, FirstStepFollowsThePrintedEquationsForAnyMatrix) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(10 + seed);
    const Eigen::MatrixXd H = normal_matrix(4, 9, rng);
    MatrixMap map = map_of(H);
    const std::vector<double> y = normal_vector(4, rng);
    const double Q = 0.3, R = 0.7;
    const Eigen::MatrixXd sigma = (1.0 + R) * Eigen::MatrixXd::Identity(9, 9);  // (40)
    const Eigen::MatrixXd K =
        sigma * H.transpose() * (H * sigma * H.transpose() + Q * Eigen::MatrixXd::Identity(4, 4)).inverse();  // (41)
    const KalmanEstimate estimate = kalman_step(map, y, Q, R);
    EXPECT_LE((estimate.mean - K * vector_of(y)).norm(), 1e-12);                                     // (42)
    EXPECT_LE((whole(estimate) - (Eigen::MatrixXd::Identity(9, 9) - K * H) * sigma).norm(), 1e-12);  // (43)
  }
}

TEST(KalmanCs, RankOneUpdatesEqualTheMatrixProducts) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(20 + seed);
    const bool orthonormal = seed % 2 == 0;
    const Eigen::MatrixXd H =
        orthonormal ? Eigen::MatrixXd(orthogonal_matrix(15, rng).topRows(6)) : normal_matrix(6, 15, rng);
    MatrixMap map = map_of(H);
    const std::vector<double> y = measured(map, sparse_vector(15, 2, rng));
    const Eigen::VectorXd expected = slow::kalman_cs(H, vector_of(y), 200);
    KalmanCs parameters;
    parameters.tau = 201;
    EXPECT_LE((vector_of(recover(parameters, map, y).x) - expected).norm(), 1e-10);
  }
}

TEST(KalmanCsP, OnePassEqualsTheMatrixProductsInEveryReading) {
  for (const Reading reading : {Reading::kAsPrinted, Reading::kTrueGradient, Reading::kPowerSum}) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
      Rng rng = rng_of(40 + seed);
      // A selection leaves coefficients at exactly 0, where the derivative has its pole.
      MatrixMap map =
          seed % 2 == 0 ? map_of(orthogonal_matrix(15, rng).topRows(6)) : selection_of(random_entries(6, 15, rng), 15);
      const std::vector<double> y = normal_vector(6, rng);
      const KalmanCsP parameters = with_passes(reading, 1);
      const Eigen::VectorXd expected = slow::kalman_cs_p(explicit_matrix(map), vector_of(y), parameters, 1);
      EXPECT_LE((vector_of(recover(parameters, map, y).x) - expected).norm(), 1e-11 * (1.0 + expected.norm()));
    }
  }
}

TEST(KalmanCsP, ReadingsDiffer) {
  Rng rng = rng_of(50);
  MatrixMap map = map_of(orthogonal_matrix(15, rng).topRows(6));
  const std::vector<double> y = measured(map, sparse_vector(15, 2, rng));
  const std::vector<double> printed = recover(with_passes(Reading::kAsPrinted, 5), map, y).x;
  const std::vector<double> gradient = recover(with_passes(Reading::kTrueGradient, 5), map, y).x;
  const std::vector<double> power = recover(with_passes(Reading::kPowerSum, 5), map, y).x;
  EXPECT_GT(largest_difference(printed, gradient), 1e-6);
  EXPECT_GT(largest_difference(printed, power), 1e-6);
  EXPECT_GT(largest_difference(gradient, power), 1e-6);
}

TEST(Kalman, PassesShrinkTheCovarianceAndKeepItPositive) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(60 + seed);
    MatrixMap map = map_of(orthogonal_matrix(10, rng).topRows(4));
    KalmanEstimate estimate = kalman_step(map, normal_vector(4, rng), kQ, 0.0);
    Eigen::VectorXd scratch(10);
    double trace = estimate.covariance.trace();
    for (int pass = 0; pass < 50; ++pass) {
      const Eigen::VectorXd h = vector_of(normal_vector(10, rng));
      apply_pseudo_measurement(estimate, h, h.dot(estimate.mean), 10.0, scratch);
      EXPECT_LT(estimate.covariance.trace(), trace);
      trace = estimate.covariance.trace();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(estimate.covariance);  // reads the lower triangle
      EXPECT_GE(eigen.eigenvalues().minCoeff(), -1e-14);
    }
  }
}

TEST(KalmanCs, DependsOnlyOnTheRowSpace) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    Rng rng = rng_of(80 + seed);
    const Eigen::MatrixXd H = orthogonal_matrix(20, rng).topRows(8);
    const Eigen::MatrixXd U = orthogonal_matrix(8, rng);
    MatrixMap map = map_of(H), turned = map_of(U * H);
    const std::vector<double> y = measured(map, sparse_vector(20, 3, rng));
    EXPECT_LE(largest_difference(recover(KalmanCs{}, map, y).x, recover(KalmanCs{}, turned, operator_times(U, y)).x),
              1e-12);
  }
}

/// How far the answer to 16 y is from 16 times the answer to y.
double scaling_defect(const Recovery& recovery, std::uint32_t seed) {
  Rng rng = rng_of(seed);
  MatrixMap map = map_of(orthogonal_matrix(20, rng).topRows(8));
  std::vector<double> y = measured(map, sparse_vector(20, 3, rng));
  std::vector<double> x = recover(recovery, map, y).x;
  for (double& v : y) v *= 16.0;
  for (double& v : x) v *= 16.0;
  return largest_difference(x, recover(recovery, map, y).x);
}

// The gains depend on the signs alone and the l1 norm is homogeneous; a constraint on |c|^p with other exponents is
// not.
TEST(Kalman, OnlyTheL1FormIsEquivariantUnderScaling) {
  EXPECT_LE(scaling_defect(KalmanCs{}, 90), 1e-12);
  EXPECT_GT(scaling_defect(with_passes(Reading::kAsPrinted, 5), 90), 1e-3);
  EXPECT_GT(scaling_defect(with_passes(Reading::kPowerSum, 5), 90), 1e-3);
}

TEST(KalmanCs, IsNearButNotExactWhenEverythingIsMeasured) {
  Rng rng = rng_of(91);
  MatrixMap map = map_of(orthogonal_matrix(16, rng));
  const std::vector<double> c = sparse_vector(16, 4, rng);
  const double mse = squared_distance(recover(KalmanCs{}, map, measured(map, c)).x, c) / 16.0;
  EXPECT_GT(mse, 0.0);
  EXPECT_LT(mse, 1e-4);
}

// Euler: grad ||c||_p . c = ||c||_p, so with the true gradient eq. 58 is line 16 of Alg. 6; with eq. 57's exponent
// it is not.
TEST(KalmanCsP, TrueGradientMakesEquation58EqualLine16) {
  Rng rng = rng_of(92);
  const std::vector<double> c = normal_vector(30, rng);
  for (const double p : {0.2, 0.4, 0.9}) {
    double sum = 0.0;
    for (const double v : c) sum += std::pow(std::abs(v), p);
    double gradient_dot_c = 0.0, printed_dot_c = 0.0;
    for (const double v : c) {
      gradient_dot_c += std::pow(sum, 1.0 / p - 1.0) * std::pow(std::abs(v), p - 1.0) * std::abs(v);
      printed_dot_c += std::pow(sum, 1.0 / (p - 1.0)) * std::pow(std::abs(v), p - 1.0) * std::abs(v);
    }
    const double norm = std::pow(sum, 1.0 / p);
    EXPECT_NEAR(gradient_dot_c, norm, 1e-12 * norm);
    EXPECT_GT(std::abs(printed_dot_c - norm), 0.5 * norm);
  }
}

TEST(KalmanCsP, ZeroDataStayZero) {
  Rng rng = rng_of(93);
  MatrixMap map = map_of(orthogonal_matrix(8, rng).topRows(3));
  for (const Reading reading : {Reading::kAsPrinted, Reading::kTrueGradient, Reading::kPowerSum}) {
    const Recovered result = recover(KalmanCsP::of(reading), map, std::vector<double>(3, 0.0));
    EXPECT_TRUE(result.converged);
    EXPECT_THAT(result.x, testing::Each(0.0));
  }
}

TEST(KalmanCsP, SaysSoWhenItDiverges) {
  Rng rng = rng_of(94);
  MatrixMap map = map_of(orthogonal_matrix(64, rng).topRows(48));
  KalmanCsP parameters;
  parameters.p = 0.003;  // (sum |c|^p)^(1/p) overflows
  std::vector<double> y = normal_vector(48, rng);
  EXPECT_FALSE(recover(parameters, map, y).converged);
}

TEST(Kalman, RefusesVariancesThatAreNotPositive) {
  MatrixMap map({1.0, 0.0}, 1, 2);
  EXPECT_THROW(static_cast<void>(recover(KalmanCs{.measurement_variance = 0.0}, map, std::vector{1.0})),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(recover(KalmanCsP{.p = 1.0}, map, std::vector{1.0})), ContractViolation);
}

}  // namespace
}  // namespace cogslam
