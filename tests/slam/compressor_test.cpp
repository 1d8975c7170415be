#include "slam/codec/compressor.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/check.hpp"
#include "core/rng.hpp"
#include "slam/codec/top_m.hpp"
#include "slam/recover/linear_map.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/slow_transforms.hpp"

namespace cogslam {
namespace {

static_assert(LinearMap<Compressor> && LinearMap<ForwardThenCompress> && LinearMap<InverseThenCompress>);

constexpr std::array kSeeded{CompressorKind::kSelection, CompressorKind::kGaussian, CompressorKind::kHadamard,
                             CompressorKind::kDct, CompressorKind::kNoiselet};

std::vector<double> random_values(std::size_t count, Rng& rng) {
  std::vector<double> values(count);
  for (double& value : values) value = rng.normal();
  return values;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Column by column, out of products with unit vectors.
template <LinearMap A>
Eigen::MatrixXd matrix_of(A& a) {
  Eigen::MatrixXd matrix(a.rows(), a.cols());
  std::vector<double> unit(a.cols(), 0.0), column(a.rows());
  for (std::size_t j = 0; j < a.cols(); ++j) {
    unit[j] = 1.0;
    std::ranges::fill(column, std::nan(""));
    a.apply(unit, column);
    unit[j] = 0.0;
    matrix.col(static_cast<Eigen::Index>(j)) = Eigen::Map<const Eigen::VectorXd>(column.data(), matrix.rows());
  }
  return matrix;
}

template <LinearMap A>
void expect_adjoint(A& a, Rng& rng) {
  const std::vector<double> x = random_values(a.cols(), rng), y = random_values(a.rows(), rng);
  std::vector<double> ax(a.rows(), std::nan("")), aty(a.cols(), std::nan(""));
  a.apply(x, ax);
  a.apply_transpose(y, aty);
  EXPECT_NEAR(dot(ax, y), dot(x, aty), 1e-13 * std::sqrt(dot(x, x) * dot(y, y)));
}

double distance_from_orthonormal(const Eigen::MatrixXd& rows) {
  return rows.rows() == 0
             ? 0.0
             : (rows * rows.transpose() - Eigen::MatrixXd::Identity(rows.rows(), rows.rows())).cwiseAbs().maxCoeff();
}

/// Every kind with random sizes and seeds.
template <class Law>
void for_random_compressors(Law law) {
  for (const CompressorKind kind : kSeeded) {
    for (std::uint32_t round = 0; round < 20; ++round) {
      Rng rng({.seed = 21, .purpose = Purpose::kWorld, .entity = round});
      const std::size_t n = exists_for(kind, 12) && round % 2 == 0 ? 1 + rng.below(90) : std::size_t{1} << rng.below(8);
      const std::size_t m = rng.below(static_cast<std::uint32_t>(n) + 1);
      SCOPED_TRACE(std::string(name_of(kind)) + " " + std::to_string(m) + " of " + std::to_string(n));
      law(kind, m, n, rng.bits());
    }
  }
}

TEST(Compressor, HasOrthonormalRows) {
  for_random_compressors([](CompressorKind kind, std::size_t m, std::size_t n, std::uint32_t seed) {
    Compressor h = make_compressor(kind, m, n, seed);
    EXPECT_EQ(h.rows(), m);
    EXPECT_EQ(h.cols(), n);
    EXPECT_TRUE(h.orthonormal_rows());
    EXPECT_LT(distance_from_orthonormal(matrix_of(h)), 1e-13);
  });
}

// The last rows of a square matrix are what little the others leave of a random vector: one pass of Gram-Schmidt would
// lose up to seven digits of their right angles.
TEST(Compressor, KeepsGaussianRowsOrthonormalUpToTheLast) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    Compressor h = make_compressor(CompressorKind::kGaussian, 128, 128, seed);
    EXPECT_LT(distance_from_orthonormal(matrix_of(h)), 1e-14);
  }
}

TEST(Compressor, TransposesItself) {
  for_random_compressors([](CompressorKind kind, std::size_t m, std::size_t n, std::uint32_t seed) {
    Compressor h = make_compressor(kind, m, n, seed);
    Rng rng({.seed = seed, .purpose = Purpose::kWorld});
    expect_adjoint(h, rng);
  });
}

TEST(Compressor, NestsItsRowsForOneSeed) {
  for_random_compressors([](CompressorKind kind, std::size_t m, std::size_t n, std::uint32_t seed) {
    Compressor few = make_compressor(kind, m, n, seed);
    Compressor all = make_compressor(kind, n, n, seed);
    const Eigen::MatrixXd rows = matrix_of(few);
    EXPECT_LE((rows - matrix_of(all).topRows(rows.rows())).norm(), 1e-14);
  });
}

TEST(Compressor, ChangesWithItsSeed) {
  for (const CompressorKind kind : kSeeded) {
    Compressor a = make_compressor(kind, 16, 64, 1), b = make_compressor(kind, 16, 64, 2);
    EXPECT_GT((matrix_of(a) - matrix_of(b)).norm(), 1.0) << name_of(kind);
  }
}

TEST(Compressor, TakesRowsOfTheMatricesOfTheirDefinitions) {
  const std::vector<std::uint32_t> rows{5, 0, 31, 17};
  const Eigen::VectorXi picked = (Eigen::VectorXi(4) << 5, 0, 31, 17).finished();
  Compressor hadamard = Compressor::transform_rows(CompressorKind::kHadamard, rows, 32);
  EXPECT_LT((matrix_of(hadamard) - slow::hadamard_matrix(32)(picked, Eigen::all)).norm(), 1e-13);
  Compressor dct = Compressor::transform_rows(CompressorKind::kDct, rows, 33);
  EXPECT_LT((matrix_of(dct) - slow::dct_matrix(33)(picked, Eigen::all)).norm(), 1e-13);
}

TEST(Compressor, TakesRealAndImaginaryPartsOfNoiselets) {
  for (const int bits : {1, 2, 3, 4, 5}) {
    const int n = 1 << bits;
    std::vector<std::uint32_t> rows(static_cast<std::size_t>(n));
    std::iota(rows.begin(), rows.end(), 0U);
    Compressor compressor = Compressor::transform_rows(CompressorKind::kNoiselet, rows, rows.size());
    const Eigen::MatrixXd real = matrix_of(compressor);
    const Eigen::MatrixXcd complex = slow::complex_noiselets(n);
    const std::complex<double> phase = std::polar(std::numbers::sqrt2, std::numbers::pi / 4.0 * (1 + bits));
    for (int j = 0; j < n / 2; ++j) {
      int reversed = 0;  // the recursion makes the last bit of the row belong to the first of the column
      for (int bit = 0; bit < bits; ++bit) reversed |= (j >> bit & 1) << (bits - 1 - bit);
      const Eigen::RowVectorXcd row = phase * complex.row(reversed);
      EXPECT_LT((real.row(j) - row.real()).norm(), 1e-13);
      EXPECT_LT((real.row(n - 1 - j) - row.imag()).norm(), 1e-13);
    }
    EXPECT_NEAR(real.cwiseAbs().maxCoeff(), real.cwiseAbs().minCoeff(), 1e-13);  // flat: +-1/sqrt(n)
  }
}

TEST(Compressor, SpreadsGaussianRowsOverTheSphere) {
  // E ||H c||^2 = (m/n) ||c||^2, standard deviation ||c||^2 sqrt(2 m (n-m) / (n^2 (n+2))): mean of 400 within 4 sigma.
  const std::size_t m = 16, n = 48;
  double sum = 0.0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    Compressor h = make_compressor(CompressorKind::kGaussian, m, n, seed);
    std::vector<double> c(n, 0.0), y(m);
    c[3] = 0.6, c[40] = 0.8;
    h.apply(c, y);
    sum += dot(y, y);
  }
  const double sigma = std::sqrt(2.0 * 16 * 32 / (48.0 * 48.0 * 50.0));
  EXPECT_NEAR(sum / 400, 16.0 / 48.0, 4.0 * sigma / 20.0);
}

TEST(Compressor, PicksEveryPositionEquallyOften) {
  std::vector<int> count(20, 0);
  for (std::uint32_t seed = 0; seed < 4000; ++seed) {
    const Compressor h = make_compressor(CompressorKind::kSelection, 5, 20, seed);
    for (const std::uint32_t index : h.indices()) ++count[index];
  }
  for (const int hits : count) EXPECT_NEAR(hits, 1000, 4 * std::sqrt(4000 * 0.25 * 0.75));
}

TEST(Compressor, KeepsTheLargestLikeTheFloatSelection) {
  for (std::uint32_t round = 0; round < 40; ++round) {
    Rng rng({.seed = 22, .purpose = Purpose::kWorld, .entity = round});
    std::vector<float> values(1 + rng.below(200));
    for (float& value : values) value = static_cast<float>(static_cast<int>(rng.below(9)) - 4);  // many equal ones
    const std::size_t m = rng.below(static_cast<std::uint32_t>(values.size()) + 1);
    CoefficientCode code;
    TopMScratch scratch;
    select_top_m(values, m, code, scratch);
    Compressor h = make_top_m(std::vector<double>(values.begin(), values.end()), m);
    EXPECT_TRUE(h.is_selection());
    EXPECT_THAT(h.indices(), testing::ElementsAreArray(code.indices));
  }
}

TEST(Compressor, LosesLeastByTheLargest) {
  Rng rng({.seed = 23, .purpose = Purpose::kWorld});
  const std::vector<double> c = random_values(64, rng);
  double before = dot(c, c);
  for (std::size_t m = 0; m <= 64; m += 8) {
    Compressor top = make_top_m(c, m);
    std::vector<double> y(top.rows());
    top.apply(c, y);
    const double error = dot(c, c) - dot(y, y);
    EXPECT_LE(error, before);
    before = error;
    Compressor other = make_compressor(CompressorKind::kSelection, m, 64, 1);
    std::vector<double> z(m);
    other.apply(c, z);
    EXPECT_GE(dot(c, c) - dot(z, z), error - 1e-12);
  }
  EXPECT_NEAR(before, 0.0, 1e-12);
}

TEST(Compressor, AppliesAGivenMatrix) {
  const Eigen::MatrixXd rows =
      Eigen::MatrixXd::NullaryExpr(3, 5, [](Eigen::Index i, Eigen::Index j) { return static_cast<double>(i * 5 + j); });
  Compressor h = Compressor::matrix(rows, false);
  EXPECT_EQ(matrix_of(h), rows);
  EXPECT_FALSE(h.orthonormal_rows());
  Rng rng({.seed = 24, .purpose = Purpose::kWorld});
  expect_adjoint(h, rng);
}

TEST(Compressor, ComposesWithABasis) {
  for (const BasisKind kind : {BasisKind::kHaar, BasisKind::kHaar1d, BasisKind::kDct, BasisKind::kIdentity}) {
    for (const auto& [width, height] : {std::pair{4, 8}, {5, 3}}) {
      const Basis basis(kind, width, height);
      SCOPED_TRACE(name_of(kind));
      const Eigen::MatrixXd phi_t = slow::basis_matrix(kind, width, height);
      Compressor h = make_compressor(CompressorKind::kDct, 6, basis.size(), 3);
      ForwardThenCompress measure(basis, h);
      EXPECT_LT((matrix_of(measure) - matrix_of(h) * phi_t).norm(), 1e-12);
      EXPECT_EQ(measure.orthonormal_rows(), distance_from_orthonormal(matrix_of(measure)) < 1e-12);
      Compressor cells = make_compressor(CompressorKind::kSelection, 6, basis.cells(), 3);
      InverseThenCompress sample(basis, cells);
      EXPECT_LT((matrix_of(sample) - matrix_of(cells) * phi_t.transpose()).norm(), 1e-12);
      EXPECT_LT(distance_from_orthonormal(matrix_of(sample)), 1e-12);
      EXPECT_TRUE(sample.orthonormal_rows());
      EXPECT_EQ(sample.is_selection(), kind == BasisKind::kIdentity);
      Rng rng({.seed = 25, .purpose = Purpose::kWorld});
      expect_adjoint(measure, rng);
      expect_adjoint(sample, rng);
    }
  }
}

TEST(Compressor, RefusesWhatDoesNotExist) {
  EXPECT_FALSE(exists_for(CompressorKind::kHadamard, 12));
  EXPECT_FALSE(exists_for(CompressorKind::kNoiselet, 100));
  EXPECT_TRUE(exists_for(CompressorKind::kDct, 12));
  EXPECT_THROW(make_compressor(CompressorKind::kHadamard, 3, 12, 1), ContractViolation);
  EXPECT_THROW(make_compressor(CompressorKind::kTopM, 3, 16, 1), ContractViolation);
  EXPECT_THROW(make_compressor(CompressorKind::kDct, 17, 16, 1), ContractViolation);
  EXPECT_THROW(Compressor::selection({3, 3}, 16), ContractViolation);
  EXPECT_THROW(Compressor::transform_rows(CompressorKind::kDct, {16}, 16), ContractViolation);
}

TEST(Compressor, HasNamesThatReadBack) {
  for (const CompressorKind kind : kSeeded) EXPECT_EQ(compressor_kind(name_of(kind)), kind);
  EXPECT_EQ(compressor_kind("top_m"), CompressorKind::kTopM);
  EXPECT_EQ(compressor_kind("sparse"), std::nullopt);
}

TEST(Golden, MeasurementsOfTheSignal) {
  SKIP_WITHOUT_GOLDEN();
  const std::vector<double> rows = golden::read("golden/H128_rows_m96.csv");
  ASSERT_EQ(rows.size(), 96U * 128U);
  const Eigen::MatrixXd matrix =
      Eigen::Map<const Eigen::Matrix<double, 96, 128, Eigen::RowMajor>>(rows.data()).topRows(64);
  EXPECT_LT(distance_from_orthonormal(matrix), 1e-13);
  Compressor h = Compressor::matrix(matrix, true);
  std::vector<double> y(64);
  h.apply(golden::read("golden/signal_dct.csv"), y);
  const std::vector<double> expected = golden::read("golden/y_m64.csv");
  for (std::size_t i = 0; i < 64; ++i) EXPECT_NEAR(y[i], expected[i], 1e-13);
}

TEST(Golden, HadamardRowsInAGivenOrder) {
  SKIP_WITHOUT_GOLDEN();
  std::vector<std::uint32_t> order;
  for (const double row : golden::read("golden/hadamard_rowperm_lcg4096.csv")) {
    order.push_back(static_cast<std::uint32_t>(row));
  }
  ASSERT_EQ(order.size(), 4096U);
  order.resize(kept_count(4096, 40.0));
  const std::vector<double> all = golden::read("golden/hadamard_of_haar2d_ideal.csv");
  Compressor h = Compressor::transform_rows(CompressorKind::kHadamard, order, 4096);
  std::vector<double> y(h.rows());
  h.apply(golden::read("golden/haar2d_ideal.csv"), y);
  for (std::size_t i = 0; i < y.size(); ++i) ASSERT_NEAR(y[i], all[order[i]], 1e-12);
}

}  // namespace
}  // namespace cogslam
