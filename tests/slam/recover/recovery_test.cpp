#include "slam/recover/recovery.hpp"

#include <gmock/gmock.h>

#include "core/check.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/random_measurements.hpp"

namespace cogslam {
namespace {

using namespace test;

static_assert(LinearMap<MatrixMap> && LinearMap<MapView>);

/// A map of any size without entries: for questions about size alone.
struct HugeMap {
  std::size_t m, n;
  [[nodiscard]] std::size_t rows() const { return m; }
  [[nodiscard]] std::size_t cols() const { return n; }
  [[nodiscard]] bool orthonormal_rows() const { return true; }
  [[nodiscard]] bool is_selection() const { return false; }
  void apply(std::span<const double> /*x*/, std::span<double> /*out*/) {}
  void apply_transpose(std::span<const double> /*y*/, std::span<double> /*out*/) {}
};

TEST(MatrixMap, MeasuresItsTraits) {
  Rng rng = rng_of(1);
  const Eigen::MatrixXd Q = orthogonal_matrix(6, rng).topRows(4);
  EXPECT_TRUE(map_of(Q).orthonormal_rows());
  EXPECT_FALSE(map_of(Q).is_selection());
  EXPECT_FALSE(map_of(1.001 * Q).orthonormal_rows());
  EXPECT_FALSE(map_of(Q.transpose()).orthonormal_rows());
  const std::vector<std::size_t> entries = {4, 1};
  EXPECT_TRUE(selection_of(entries, 6).is_selection());
  EXPECT_TRUE(selection_of(entries, 6).orthonormal_rows());
  const std::vector<std::size_t> twice = {4, 4};
  EXPECT_TRUE(selection_of(twice, 6).is_selection());
  EXPECT_FALSE(selection_of(twice, 6).orthonormal_rows());
  EXPECT_FALSE(MatrixMap({0.0, 0.0}, 1, 2).is_selection());
}

TEST(MatrixMap, ProductsAreAdjointAndExplicitMatrixIsTheMatrix) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(10 + seed);
    const Eigen::MatrixXd A = normal_matrix(1 + rng.below(9), 1 + rng.below(9), rng);
    MatrixMap map = map_of(A);
    const std::vector<double> x = normal_vector(map.cols(), rng), y = normal_vector(map.rows(), rng);
    std::vector<double> back(map.cols());
    map.apply_transpose(y, back);
    const std::vector<double> ax = measured(map, x);
    EXPECT_NEAR(std::inner_product(y.begin(), y.end(), ax.begin(), 0.0),
                std::inner_product(x.begin(), x.end(), back.begin(), 0.0), 1e-12);
    EXPECT_LE((explicit_matrix(map) - A).norm(), 1e-15);
    EXPECT_NEAR(residual_norm(map, x, y), std::sqrt(squared_distance(ax, y)), 1e-14);
  }
}

TEST(MatrixMap, RefusesTheWrongNumberOfEntries) { EXPECT_THROW(MatrixMap({1.0, 2.0}, 1, 3), ContractViolation); }

TEST(Recovery, EveryNameStandsForOneRecovery) {
  for (const std::string_view name : kRecoveryNames) {
    const auto recovery = recovery_named(name);
    ASSERT_TRUE(recovery.has_value()) << name;
    EXPECT_EQ(name_of(*recovery), name);
  }
  EXPECT_FALSE(recovery_named("l2").has_value());
}

TEST(Recovery, DispatchesToTheSolver) {
  Rng rng = rng_of(30);
  MatrixMap map = map_of(orthogonal_matrix(12, rng).topRows(6));
  const std::vector<double> y = measured(map, sparse_vector(12, 2, rng));
  EXPECT_EQ(recover(Recovery{Nesta{}}, map, y).x, recover(Nesta{}, map, y).x);
  EXPECT_EQ(recover(Recovery{FastL2{}}, map, y).x, recover(FastL2{}, map, y).x);
  EXPECT_EQ(recover(Recovery{KalmanCs{}}, map, y).x, recover(KalmanCs{}, map, y).x);
}

TEST(Recovery, SaysWhatAMatrixLacks) {
  MatrixMap skew({1.0, 1.0}, 1, 2);
  const std::vector<double> y = {1.0};
  const auto text = [&](const Recovery& recovery) {
    return error_text([&] { static_cast<void>(recover(recovery, skew, y)); });
  };
  EXPECT_EQ(text(FastL2{}),
            "fast_l2 needs a measurement matrix with orthonormal rows, which this one has not; use pinv");
  EXPECT_EQ(text(Nesta{}), "nesta needs a measurement matrix with orthonormal rows, which this one has not; use pinv");
  EXPECT_EQ(text(TotalVariation{2, 1}), "tv recovers a map from some of its cells; this matrix mixes cells");
  EXPECT_EQ(text(PseudoInverse{}), "no error");
  EXPECT_EQ(text(KalmanCs{}), "no error");
}

TEST(Recovery, SaysWhatIsTooLargeOrOfAnotherShape) {
  HugeMap huge{4096, 8192};
  EXPECT_EQ(why_not(PseudoInverse{}, huge),
            "pinv stores the m x n matrix and takes at most m n = 16777216, here m = 4096, n = 8192");
  EXPECT_EQ(why_not(KalmanCs{}, huge),
            "the Kalman recoveries keep an n x n covariance and take at most n = 4096, here n = 8192");
  EXPECT_TRUE(why_not(KalmanCsP{}, huge).has_value());
  EXPECT_FALSE(why_not(Nesta{}, huge).has_value());
  const std::vector<std::size_t> entries = {2};
  MatrixMap picking = selection_of(entries, 6);
  EXPECT_EQ(why_not(TotalVariation{2, 2}, picking),
            "tv is set up for a map of 2 x 2 cells, but the matrix has 6 columns");
  EXPECT_FALSE(why_not(TotalVariation{3, 2}, picking).has_value());
  const std::vector<std::size_t> repeated = {2, 2};
  MatrixMap twice = selection_of(repeated, 6);
  EXPECT_EQ(why_not(TotalVariation{3, 2}, twice), "tv takes each known cell once; this selection repeats a cell");
}

}  // namespace
}  // namespace cogslam
