#include <gmock/gmock.h>

#include <algorithm>

#include "core/check.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/recover/fast_l2.hpp"
#include "slam/recover/pinv.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random_measurements.hpp"

namespace cogslam {
namespace {

using namespace test;
using Decomposition = PseudoInverse::Decomposition;

double l2_error(const Eigen::MatrixXd& H, const std::vector<double>& c) {
  MatrixMap h = map_of(H);
  return squared_distance(recover(FastL2{}, h, measured(h, c)).x, c);
}

TEST(L2, EqualsTheReference) {
  SKIP_WITHOUT_GOLDEN();
  std::vector<double> rows = golden::read("golden/H128_rows_m96.csv");
  rows.resize(64 * 128);
  MatrixMap H(std::move(rows), 64, 128);
  const std::vector<double> y = golden::read("golden/y_m64.csv");
  const std::vector<double> expected = golden::read("golden/c_m64_l2.csv");
  EXPECT_LE(largest_difference(recover(FastL2{}, H, y).x, expected), 1e-12);
  for (const auto decomposition : {Decomposition::kOrthogonal, Decomposition::kSvd}) {
    const Recovered pinv = recover(PseudoInverse{decomposition}, H, y);
    EXPECT_LE(largest_difference(pinv.x, expected), 1e-12);
    EXPECT_LE(pinv.residual, 1e-12);
    EXPECT_TRUE(pinv.converged);
  }
}

TEST(L2, FastEqualsPseudoInverseForOrthonormalRows) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng = rng_of(seed);
    const std::size_t n = 2 + rng.below(40);
    const std::size_t m = 1 + rng.below(static_cast<std::uint32_t>(n));
    MatrixMap dense =
        map_of(orthogonal_matrix(static_cast<Eigen::Index>(n), rng).topRows(static_cast<Eigen::Index>(m)));
    MatrixMap selection = selection_of(random_entries(m, n, rng), n);
    for (MatrixMap* h : {&dense, &selection}) {
      const std::vector<double> y = normal_vector(m, rng);
      const std::vector<double> fast = recover(FastL2{}, *h, y).x;
      EXPECT_LE(largest_difference(fast, recover(PseudoInverse{}, *h, y).x), 1e-13);
      EXPECT_LE(largest_difference(fast, recover(PseudoInverse{Decomposition::kSvd}, *h, y).x), 1e-13);
    }
  }
}

TEST(L2, FastScattersASelectionOverZeros) {
  const std::vector<std::size_t> entries = {3, 0};
  MatrixMap h = selection_of(entries, 5);
  EXPECT_THAT(recover(FastL2{}, h, std::vector{7.0, -2.0}).x, testing::ElementsAre(-2.0, 0.0, 0.0, 7.0, 0.0));
}

TEST(L2, FastRefusesRowsThatAreNotOrthonormal) {
  MatrixMap h({1.0, 1.0}, 1, 2);
  EXPECT_THROW(static_cast<void>(recover(FastL2{}, h, std::vector{1.0})), ContractViolation);
}

TEST(L2, PseudoInverseMeetsThePenroseConditions) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(100 + seed);
    // Of rank 3: neither the rows nor the columns are independent.
    const Eigen::MatrixXd A = normal_matrix(6, 3, rng) * normal_matrix(3, 8, rng);
    MatrixMap map = map_of(A);
    Eigen::MatrixXd pinv(8, 6);
    for (Eigen::Index i = 0; i < 6; ++i) {
      std::vector<double> unit(6, 0.0);
      unit[static_cast<std::size_t>(i)] = 1.0;
      const std::vector<double> column =
          recover(PseudoInverse{seed % 2 == 0 ? Decomposition::kOrthogonal : Decomposition::kSvd}, map, unit).x;
      pinv.col(i) = Eigen::Map<const Eigen::VectorXd>(column.data(), 8);
    }
    const double scale = A.norm();
    EXPECT_LE((A * pinv * A - A).norm(), 1e-11 * scale);
    EXPECT_LE((pinv * A * pinv - pinv).norm(), 1e-11 * scale);
    EXPECT_LE((A * pinv - (A * pinv).transpose()).norm(), 1e-11 * scale);
    EXPECT_LE((pinv * A - (pinv * A).transpose()).norm(), 1e-11 * scale);
  }
}

TEST(L2, SquaredErrorIsTheNormThatWasNotMeasured) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(200 + seed);
    const Eigen::MatrixXd Q = orthogonal_matrix(24, rng);
    const std::vector<double> c = normal_vector(24, rng);
    const double energy = squared_distance(c, std::vector<double>(24, 0.0));
    double previous = energy;
    for (Eigen::Index m = 1; m <= 24; ++m) {
      const std::vector<double> y = operator_times(Q.topRows(m), c);
      const double error = l2_error(Q.topRows(m), c);
      EXPECT_NEAR(error, energy - squared_distance(y, std::vector<double>(y.size(), 0.0)), 1e-12 * energy);
      EXPECT_LE(error, previous + 1e-12 * energy);
      previous = error;
    }
    EXPECT_LE(previous, 1e-12 * energy);
  }
}

TEST(L2, MeanErrorOverRandomRowsIsTheShareNotMeasured) {
  Rng rng = rng_of(300);
  const std::vector<double> c = sparse_vector(48, 9, rng);
  const double energy = squared_distance(c, std::vector<double>(48, 0.0));
  const double m = 20.0, n = 48.0;
  const int draws = 400;
  double mean = 0.0;
  for (int i = 0; i < draws; ++i) mean += l2_error(orthogonal_matrix(48, rng).topRows(20), c) / draws;
  const double deviation = energy * std::sqrt(2.0 * m * (n - m) / (n * n * (n + 2.0)) / draws);
  EXPECT_NEAR(mean, (1.0 - m / n) * energy, 4.0 * deviation);
}

TEST(L2, MeanErrorOverRandomHadamardRowsIsTheSame) {
  Rng rng = rng_of(350);
  const std::vector<double> c = normal_vector(64, rng);
  const double energy = squared_distance(c, std::vector<double>(64, 0.0));
  const double m = 24.0, n = 64.0;
  const int draws = 400;
  double mean = 0.0;
  for (std::uint32_t seed = 0; seed < draws; ++seed) {
    Compressor h = make_compressor(CompressorKind::kHadamard, 24, 64, seed);
    std::vector<double> y(24);
    h.apply(c, y);
    mean += squared_distance(recover(FastL2{}, h, y).x, c) / draws;
  }
  EXPECT_NEAR(mean, (1.0 - m / n) * energy, 0.02 * energy);
}

TEST(L2, DependsOnlyOnTheRowSpaceAndScalesWithItsData) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(360 + seed);
    const Eigen::MatrixXd H = orthogonal_matrix(20, rng).topRows(8), U = orthogonal_matrix(8, rng);
    MatrixMap map = map_of(H), turned = map_of(U * H);
    std::vector<double> y = normal_vector(8, rng);
    std::vector<double> x = recover(FastL2{}, map, y).x;
    EXPECT_LE(largest_difference(x, recover(FastL2{}, turned, operator_times(U, y)).x), 1e-13);
    EXPECT_LE(largest_difference(x, recover(PseudoInverse{}, turned, operator_times(U, y)).x), 1e-13);
    for (double& v : y) v *= 16.0;
    for (double& v : x) v *= 16.0;
    EXPECT_EQ(recover(FastL2{}, map, y).x, x);
    EXPECT_LE(largest_difference(recover(PseudoInverse{}, map, y).x, x), 1e-12);
  }
}

TEST(L2, NoSelectionBeatsTheLargestCoefficients) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng = rng_of(400 + seed);
    const std::vector<double> c = normal_vector(20, rng);
    std::vector<double> squares;
    for (const double v : c) squares.push_back(v * v);
    std::ranges::sort(squares);
    const std::size_t m = 1 + rng.below(20);
    const double dropped = std::accumulate(squares.begin(), squares.end() - static_cast<std::ptrdiff_t>(m), 0.0);
    MatrixMap any = selection_of(random_entries(m, 20, rng), 20);
    EXPECT_LE(dropped, squared_distance(recover(FastL2{}, any, measured(any, c)).x, c) + 1e-12);
  }
}

}  // namespace
}  // namespace cogslam
