#include "slam/codec/basis.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "core/check.hpp"
#include "core/rng.hpp"
#include "slam/codec/hadamard.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/slow_transforms.hpp"

namespace cogslam {
namespace {

constexpr std::array kAll{BasisKind::kHaar,  BasisKind::kHaarStandard, BasisKind::kHaar1d,  BasisKind::kDct,
                          BasisKind::kDct1d, BasisKind::kHadamard,     BasisKind::kIdentity};

std::vector<double> random_values(std::size_t count, Rng& rng) {
  std::vector<double> values(count);
  for (double& value : values) value = rng.normal();
  return values;
}

// Buffers start as NaN, so that a value that is never written shows.
std::vector<double> unset(std::size_t count) {
  return std::vector<double>(count, std::numeric_limits<double>::quiet_NaN());
}

std::vector<double> forward(Basis& basis, const std::vector<double>& values) {
  std::vector<double> coefficients = unset(basis.size());
  basis.forward(values, coefficients);
  return coefficients;
}

std::vector<double> inverse(Basis& basis, const std::vector<double>& coefficients) {
  std::vector<double> values = unset(basis.cells());
  basis.inverse(coefficients, values);
  return values;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void expect_near(const std::vector<double>& actual, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) ASSERT_NEAR(actual[i], expected[i], tolerance) << "at " << i;
}

struct Size {
  int width;
  int height;
};

// One cell, lines, primes, powers of two and their neighbours, and others at random.
std::vector<Size> assorted_sizes() {
  std::vector<Size> sizes{{1, 1}, {2, 1}, {1, 2}, {3, 1}, {1, 83}, {128, 1}, {16, 16}, {17, 15}, {31, 4}, {1, 97}};
  Rng rng({.seed = 5, .purpose = Purpose::kWorld});
  for (int i = 0; i < 30; ++i) {
    const int width = 1 + static_cast<int>(rng.below(60));
    sizes.push_back({width, 1 + static_cast<int>(rng.below(60))});
  }
  return sizes;
}

std::string label(BasisKind kind, Size size) {
  return std::string(name_of(kind)) + " of " + std::to_string(size.width) + " x " + std::to_string(size.height);
}

template <class Law>
void for_random_bases(Law law) {
  for (const BasisKind kind : kAll) {
    for (const Size size : assorted_sizes()) {
      SCOPED_TRACE(label(kind, size));
      Basis basis(kind, size.width, size.height);
      Rng rng({.seed = 6, .purpose = Purpose::kWorld, .entity = static_cast<std::uint32_t>(size.width)});
      law(basis, rng);
    }
  }
}

TEST(Basis, KeepsTheNorm) {
  for_random_bases([](Basis& basis, Rng& rng) {
    const std::vector<double> values = random_values(basis.cells(), rng);
    const std::vector<double> coefficients = forward(basis, values);
    EXPECT_NEAR(dot(coefficients, coefficients), dot(values, values), 1e-12 * dot(values, values));
  });
}

TEST(Basis, GivesBackItsMap) {
  for_random_bases([](Basis& basis, Rng& rng) {
    const std::vector<double> values = random_values(basis.cells(), rng);
    expect_near(inverse(basis, forward(basis, values)), values, 1e-13);
  });
}

TEST(Basis, HasItsAdjointForInverse) {
  for_random_bases([](Basis& basis, Rng& rng) {
    const std::vector<double> values = random_values(basis.cells(), rng);
    const std::vector<double> coefficients = random_values(basis.size(), rng);
    const double scale = std::sqrt(dot(values, values) * dot(coefficients, coefficients));
    EXPECT_NEAR(dot(forward(basis, values), coefficients), dot(values, inverse(basis, coefficients)), 1e-13 * scale);
  });
}

TEST(Basis, GivesBackItsCoefficientsWhereNothingIsPadded) {
  for_random_bases([](Basis& basis, Rng& rng) {
    if (basis.size() != basis.cells()) return;
    const std::vector<double> coefficients = random_values(basis.size(), rng);
    expect_near(forward(basis, inverse(basis, coefficients)), coefficients, 1e-13);
  });
}

TEST(Basis, EqualsItsMatrixFromTheDefinition) {
  for (const BasisKind kind : kAll) {
    for (const Size size : {Size{1, 1}, {8, 1}, {7, 1}, {1, 11}, {4, 8}, {8, 4}, {5, 3}, {6, 13}, {19, 2}}) {
      SCOPED_TRACE(label(kind, size));
      Basis basis(kind, size.width, size.height);
      const Eigen::MatrixXd matrix = slow::basis_matrix(kind, size.width, size.height);
      ASSERT_EQ(basis.size(), static_cast<std::size_t>(matrix.rows()));
      ASSERT_EQ(basis.cells(), static_cast<std::size_t>(matrix.cols()));
      EXPECT_NEAR((matrix.transpose() * matrix - Eigen::MatrixXd::Identity(matrix.cols(), matrix.cols())).norm(), 0.0,
                  1e-12);
      for (std::size_t cell = 0; cell < basis.cells(); ++cell) {
        std::vector<double> unit(basis.cells(), 0.0);
        unit[cell] = 1.0;
        const Eigen::VectorXd column = matrix.col(static_cast<Eigen::Index>(cell));
        expect_near(forward(basis, unit), {column.begin(), column.end()}, 1e-13);
      }
    }
  }
}

TEST(Basis, TransformsTheHallwayWhoseSidesAreNoPowersOfTwo) {
  for (const BasisKind kind : kAll) {
    Basis basis(kind, 249, 154);  // 249 = 3 * 83
    Rng rng({.seed = 7, .purpose = Purpose::kWorld});
    const std::vector<double> values = random_values(basis.cells(), rng);
    expect_near(inverse(basis, forward(basis, values)), values, 1e-12);
  }
}

TEST(Basis, CopiesTransformOnTheirOwn) {
  for (const BasisKind kind : kAll) {
    auto first = std::make_unique<Basis>(kind, 9, 5);
    Basis second = *first;
    Rng rng({.seed = 8, .purpose = Purpose::kWorld});
    const std::vector<double> values = random_values(45, rng);
    const std::vector<double> expected = forward(*first, values);
    first.reset();
    EXPECT_EQ(forward(second, values), expected);
  }
}

TEST(Basis, HasNamesThatReadBack) {
  for (const BasisKind kind : kAll) EXPECT_EQ(basis_kind(name_of(kind)), kind);
  EXPECT_EQ(basis_kind("wavelet"), std::nullopt);
}

TEST(Basis, RefusesBuffersOfTheWrongSize) {
  for (const BasisKind kind : kAll) {
    Basis basis(kind, 5, 3);
    std::vector<double> values(15), coefficients(basis.size() + 1);
    EXPECT_THROW(basis.forward(values, coefficients), ContractViolation);
    EXPECT_THROW(basis.inverse(coefficients, values), ContractViolation);
  }
}

TEST(WalshHadamard, WantsAPowerOfTwo) {
  std::vector<double> values(12, 1.0);
  EXPECT_THROW(walsh_hadamard(values), ContractViolation);
}

TEST(Golden, DctOfTheSignal) {
  SKIP_WITHOUT_GOLDEN();
  Basis basis(BasisKind::kDct, 128, 1);
  // Summed in long double, the reference values are right to 1.1e-13 and ours to 2e-15.
  expect_near(forward(basis, golden::read("golden/signal_f.csv")), golden::read("golden/signal_dct.csv"), 1e-12);
}

TEST(Golden, HaarOfTheRoom) {
  SKIP_WITHOUT_GOLDEN();
  Basis basis(BasisKind::kHaar, 64, 64);
  const std::vector<double> map = golden::read("maps/room64_ideal_logodds.csv");
  expect_near(forward(basis, map), golden::read("golden/haar2d_ideal.csv"), 1e-12);
}

TEST(Golden, HadamardOfTheRoomsHaarCoefficients) {
  SKIP_WITHOUT_GOLDEN();
  Basis basis(BasisKind::kHadamard, 64, 64);
  const std::vector<double> haar = golden::read("golden/haar2d_ideal.csv");
  const std::vector<double> hadamard = golden::read("golden/hadamard_of_haar2d_ideal.csv");
  expect_near(forward(basis, haar), hadamard, 1e-12);
  expect_near(inverse(basis, hadamard), haar, 1e-12);
}

TEST(Golden, EveryBasisKeepsTheEnergyOfTheRoom) {
  SKIP_WITHOUT_GOLDEN();
  const std::vector<double> map = golden::read("maps/room64_ideal_logodds.csv");
  for (const BasisKind kind : kAll) {
    Basis basis(kind, 64, 64);
    const std::vector<double> coefficients = forward(basis, map);
    EXPECT_NEAR(dot(coefficients, coefficients), 43824.0, 1e-7) << name_of(kind);
  }
}

}  // namespace
}  // namespace cogslam
