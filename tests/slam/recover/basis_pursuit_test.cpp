#include "slam/recover/basis_pursuit.hpp"

#include <gmock/gmock.h>

#include "core/check.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/recover/nesta.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random_measurements.hpp"
#include "tests/support/slow_recover.hpp"

namespace cogslam {
namespace {

using namespace test;

TEST(BasisPursuit, ReachesTheReferenceOptimum) {
  SKIP_WITHOUT_GOLDEN();
  std::vector<double> rows = golden::read("golden/H128_rows_m96.csv");
  rows.resize(64 * 128);
  MatrixMap H(std::move(rows), 64, 128);
  const std::vector<double> y = golden::read("golden/y_m64.csv");
  const double optimum = l1_norm(golden::read("golden/c_m64_cs_lp.csv"));
  const Recovered result = recover(BasisPursuit{.stop_at_gap = 1e-6}, H, y);
  EXPECT_TRUE(result.converged);
  EXPECT_LE(*result.duality_gap, 1e-6);
  EXPECT_NEAR(l1_norm(result.x), optimum, 1.1e-6 * optimum);
  EXPECT_LE(result.residual, 1e-12);
}

TEST(BasisPursuit, EqualsTheBestBasicSolutionOfTinyProblems) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng = rng_of(seed);
    const Eigen::MatrixXd H = orthogonal_matrix(9, rng).topRows(4);
    MatrixMap map = map_of(H);
    const std::vector<double> y = measured(map, sparse_vector(9, 6, rng));
    const double optimum =
        slow::least_l1_norm(H, Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())));
    const Recovered result = recover(BasisPursuit{.stop_at_gap = 1e-5}, map, y);
    EXPECT_TRUE(result.converged);
    EXPECT_GE(l1_norm(result.x), optimum * (1.0 - 1e-12));
    EXPECT_LE(l1_norm(result.x), optimum * (1.0 + 1.1e-5));
    EXPECT_LE(l1_norm(result.x) * (1.0 - *result.duality_gap), optimum * (1.0 + 1e-12)) << "the bound is below";
  }
}

// Cells of a map of odd sides: coefficients of the padding are unknowns like all others.
TEST(BasisPursuit, AgreesWithNestaOnSampledCells) {
  for (const BasisKind kind : {BasisKind::kHaar, BasisKind::kDct}) {
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      Rng rng = rng_of(100 + seed);
      const Compressor phi = make_compressor(CompressorKind::kSelection, 60, 11 * 19, seed);
      InverseThenCompress a(Basis(kind, 11, 19), phi);
      const std::vector<double> y = normal_vector(60, rng);
      const Recovered one = recover(BasisPursuit{.stop_at_gap = 1e-4}, a, y);
      const Recovered other = recover(Nesta::to_gap(1e-4), a, y);
      EXPECT_TRUE(one.converged && other.converged);
      EXPECT_NEAR(l1_norm(one.x), l1_norm(other.x), 1.1e-4 * l1_norm(other.x));
      EXPECT_LE(one.residual, 1e-12);
    }
  }
}

TEST(BasisPursuit, FindsSparseSignalsAndScalesWithItsData) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(200 + seed);
    MatrixMap map = map_of(orthogonal_matrix(40, rng).topRows(20));
    const std::vector<double> c = sparse_vector(40, 3, rng);
    std::vector<double> y = measured(map, c);
    const Recovered result = recover(BasisPursuit{.stop_at_gap = 1e-6}, map, y);
    EXPECT_LE(squared_distance(result.x, c), 1e-8 * squared_distance(c, std::vector<double>(40, 0.0)));
    for (double& v : y) v *= 1024.0;
    const Recovered scaled = recover(BasisPursuit{.stop_at_gap = 1e-6}, map, y);
    EXPECT_EQ(scaled.iterations, result.iterations);
    for (std::size_t i = 0; i < 40; ++i) EXPECT_DOUBLE_EQ(scaled.x[i], 1024.0 * result.x[i]);
  }
}

TEST(BasisPursuit, OfNothingIsNothing) {
  Rng rng = rng_of(300);
  MatrixMap map = map_of(orthogonal_matrix(12, rng).topRows(5));
  const Recovered result = recover(BasisPursuit{}, map, std::vector<double>(5, 0.0));
  EXPECT_THAT(result.x, testing::Each(0.0));
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.duality_gap, 0.0);
}

TEST(BasisPursuit, SaysSoWhenIterationsRunOut) {
  Rng rng = rng_of(400);
  MatrixMap map = map_of(orthogonal_matrix(40, rng).topRows(20));
  const std::vector<double> y = measured(map, normal_vector(40, rng));
  const Recovered result = recover(BasisPursuit{.stop_at_gap = 1e-9, .max_iterations = 7}, map, y);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 7);
  EXPECT_GT(*result.duality_gap, 1e-9);
  EXPECT_LE(result.residual, 1e-12);
}

TEST(BasisPursuit, AsksForOrthonormalRows) {
  MatrixMap skew({1.0, 1.0}, 1, 2);
  EXPECT_THROW(static_cast<void>(recover(BasisPursuit{}, skew, std::vector{1.0})), ContractViolation);
}

}  // namespace
}  // namespace cogslam
