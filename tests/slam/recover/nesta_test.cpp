#include "slam/recover/nesta.hpp"

#include <gmock/gmock.h>

#include "core/check.hpp"
#include "slam/recover/fast_l2.hpp"
#include "slam/recover/shrink.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random_measurements.hpp"
#include "tests/support/slow_recover.hpp"

namespace cogslam {
namespace {

using namespace test;

Eigen::VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

double largest_of(const std::vector<double>& x) { return vector_of(x).cwiseAbs().maxCoeff(); }

/// A sparse signal of 40 entries seen by 20 orthonormal rows.
struct Problem {
  Eigen::MatrixXd H;
  MatrixMap map;
  std::vector<double> c, y;

  explicit Problem(std::uint32_t seed, std::size_t nonzeros = 5, Eigen::Index m = 20, Eigen::Index n = 40)
      : map({1.0}, 1, 1) {
    Rng rng = rng_of(seed);
    H = orthogonal_matrix(n, rng).topRows(m);
    map = map_of(H);
    c = sparse_vector(static_cast<std::size_t>(n), nonzeros, rng);
    y = measured(map, c);
  }
  [[nodiscard]] std::vector<double> back() { return recover(FastL2{}, map, y).x; }
};

MatrixMap reference_rows() {
  std::vector<double> rows = golden::read("golden/H128_rows_m96.csv");
  rows.resize(64 * 128);
  return {std::move(rows), 64, 128};
}

TEST(Nesta, ReachesTheReferenceOptimum) {
  SKIP_WITHOUT_GOLDEN();
  MatrixMap H = reference_rows();
  const std::vector<double> y = golden::read("golden/y_m64.csv");
  const double optimum = l1_norm(golden::read("golden/c_m64_cs_lp.csv"));
  for (const Nesta& nesta : {Nesta{}, Nesta::to_gap(1e-4)}) {
    const Recovered result = recover(nesta, H, y);
    EXPECT_TRUE(result.converged);
    EXPECT_NEAR(l1_norm(result.x), optimum, 1e-4 * optimum);
    EXPECT_GE(l1_norm(result.x), optimum * (1.0 - 1e-12));
    EXPECT_LE(result.residual, 1e-12);
    EXPECT_LE(l1_norm(result.x) * (1.0 - *result.duality_gap), optimum * (1.0 + 1e-12));
  }
}

TEST(Nesta, ReachesTheReferenceOptimumWithNoise) {
  SKIP_WITHOUT_GOLDEN();
  MatrixMap H = reference_rows();
  const std::vector<double> y = golden::read("golden/y_m64.csv");
  for (const auto& [eps, name] : {std::pair{0.1, "bpdn_eps0.1"}, std::pair{1.0, "bpdn_eps1"}}) {
    const std::vector<double> expected = golden::read("golden/c_m64_" + std::string(name) + ".csv");
    const double optimum = l1_norm(expected);
    for (const Nesta& nesta : {Nesta{.eps = eps}, Nesta::to_gap(1e-5, eps)}) {
      const Recovered result = recover(nesta, H, y);
      EXPECT_NEAR(l1_norm(result.x), optimum, 1e-4 * optimum);
      EXPECT_LE(result.residual, eps * (1.0 + 1e-9));
      EXPECT_LE(l1_norm(result.x) * (1.0 - *result.duality_gap), optimum * (1.0 + 1e-5));
    }
    EXPECT_LE(*recover(Nesta::to_gap(1e-5, eps), H, y).duality_gap, 1e-5);
  }
}

TEST(Nesta, TakesThePrintedStepsWithHalfTheProducts) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    Problem problem(seed);
    slow::NestaParameters slow{.eps = seed % 2 == 0 ? 0.0 : 0.3, .mu_final = 1e-3, .widths = 4, .tolerance = 1e-5};
    Nesta fast{.eps = slow.eps,
               .mu_final = slow.mu_final / largest_of(problem.back()),
               .continuation = slow.widths,
               .tolerance = slow.tolerance};
    const Eigen::VectorXd expected = slow::nesta(problem.H, vector_of(problem.y), slow);
    EXPECT_LE((vector_of(recover(fast, problem.map, problem.y).x) - expected).norm(), 1e-9);
  }
}

TEST(Nesta, EqualsTheBestBasicSolutionOfTinyProblems) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Problem problem(100 + seed, 6, 4, 9);
    const double optimum = slow::least_l1_norm(problem.H, vector_of(problem.y));
    const Recovered result = recover(Nesta::to_gap(1e-5), problem.map, problem.y);
    EXPECT_TRUE(result.converged);
    EXPECT_GE(l1_norm(result.x), optimum * (1.0 - 1e-12));
    EXPECT_LE(l1_norm(result.x), optimum * (1.0 + 1.1e-5));
    EXPECT_LE(l1_norm(result.x) * (1.0 - *result.duality_gap), optimum * (1.0 + 1e-12));
  }
}

TEST(Nesta, SmoothingCostsAtMostItsBound) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Problem problem(200 + seed, 6, 4, 9);
    const double optimum = slow::least_l1_norm(problem.H, vector_of(problem.y));
    for (const double mu : {1e-1, 1e-2, 1e-3}) {
      const Recovered result = recover(Nesta{.mu_final = mu, .tolerance = 1e-11}, problem.map, problem.y);
      const double bound = 0.5 * 9.0 * mu * largest_of(problem.back());
      EXPECT_LE(l1_norm(result.x), optimum + bound + 1e-6 * optimum);
    }
  }
}

TEST(Nesta, IsFeasibleAndNoLongerThanTheTruth) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Problem problem(300 + seed, 2 + seed);
    for (const double eps : {0.0, 0.01, 0.5}) {
      const Recovered result = recover(Nesta::to_gap(1e-4, eps), problem.map, problem.y);
      EXPECT_LE(result.residual, eps > 0.0 ? eps * (1.0 + 1e-9) : 1e-13 * vector_of(problem.y).norm() + 1e-14);
      EXPECT_LE(l1_norm(result.x), l1_norm(problem.c) * (1.0 + 1.1e-4));
      EXPECT_LE(*result.duality_gap, 1e-4);
    }
  }
}

TEST(Nesta, FindsSparseSignalsExactly) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Problem problem(400 + seed, 3);
    const double error = squared_distance(recover(Nesta::to_gap(1e-6), problem.map, problem.y).x, problem.c);
    EXPECT_LE(std::sqrt(error), 1e-4 * vector_of(problem.c).norm());
  }
}

// The law for Gaussian rows: half of the k-sparse signals come back at the statistical dimension of the l1 norm's
// descent cone, 43.7 rows for n = 256 and k = 10; 30 % away in either direction hardly any or nearly all.
TEST(Nesta, FindsSparseSignalsFromTheStatisticalDimensionOn) {
  const auto found = [](Eigen::Index rows) {
    int count = 0;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      Problem problem(1000 + seed, 10, rows, 256);
      const double error = squared_distance(recover(Nesta::to_gap(1e-4), problem.map, problem.y).x, problem.c);
      count += std::sqrt(error) < 1e-2 * vector_of(problem.c).norm() ? 1 : 0;
    }
    return count;
  };
  EXPECT_LE(found(31), 3);
  EXPECT_GE(found(57), 17);
}

TEST(Nesta, BoundsTheOptimumFromBelowHoweverEarlyItEnds) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Problem problem(150 + seed, 6, 4, 9);
    const double optimum = slow::least_l1_norm(problem.H, vector_of(problem.y));
    for (const int steps : {1, 5, 30}) {
      const Recovered result = recover(Nesta{.max_iterations = steps}, problem.map, problem.y);
      EXPECT_LE(l1_norm(result.x) * (1.0 - *result.duality_gap), optimum * (1.0 + 1e-12));
    }
  }
}

TEST(Nesta, RestartsSaveIterations) {
  int with = 0, without = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Problem problem(450 + seed, 3);
    Nesta nesta = Nesta::to_gap(1e-5);
    with += recover(nesta, problem.map, problem.y).iterations;
    nesta.restart = false;
    without += recover(nesta, problem.map, problem.y).iterations;
  }
  EXPECT_LT(with, without);
}

TEST(Nesta, DependsOnlyOnTheRowSpace) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    Problem problem(500 + seed);
    Rng rng = rng_of(600 + seed);
    const Eigen::MatrixXd U = orthogonal_matrix(20, rng);
    MatrixMap turned = map_of(U * problem.H);
    EXPECT_LE(largest_difference(recover(Nesta{}, problem.map, problem.y).x,
                                 recover(Nesta{}, turned, operator_times(U, problem.y)).x),
              1e-8);
  }
}

TEST(Nesta, IsEquivariantUnderScaling) {
  for (const double eps : {0.0, 0.2}) {
    Problem problem(700);
    std::vector<double> expected = recover(Nesta{.eps = eps}, problem.map, problem.y).x;
    // A power of two, so that the scaling itself rounds nothing.
    for (double& v : expected) v *= 1024.0;
    for (double& v : problem.y) v *= 1024.0;
    EXPECT_LE(largest_difference(recover(Nesta{.eps = 1024.0 * eps}, problem.map, problem.y).x, expected), 1e-6);
  }
}

TEST(Nesta, OnASelectionScattersOrShrinks) {
  Rng rng = rng_of(800);
  MatrixMap selection = selection_of(random_entries(8, 20, rng), 20);
  const std::vector<double> y = normal_vector(8, rng);
  const std::vector<double> l2 = recover(FastL2{}, selection, y).x;
  EXPECT_LE(largest_difference(recover(Nesta{}, selection, y).x, l2), 1e-13);
  // With eps > 0 the optimum is l2 softly thresholded, at the threshold t where ||min(|y|, t)|| = eps.
  const double eps = 0.5;
  double low = 0.0, high = 10.0;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.5 * (low + high);
    double squares = 0.0;
    for (const double v : y) squares += std::pow(std::min(std::abs(v), t), 2);
    (std::sqrt(squares) < eps ? low : high) = t;
  }
  double optimum = 0.0;
  for (const double v : y) optimum += std::abs(soft_threshold(v, low));
  const Recovered noisy = recover(Nesta::to_gap(1e-6, eps), selection, y);
  EXPECT_NEAR(l1_norm(noisy.x), optimum, 2e-6 * optimum);
}

TEST(Nesta, IsExactWhenEverythingIsMeasured) {
  Problem problem(900, 12, 30, 30);
  EXPECT_LE(largest_difference(recover(Nesta{}, problem.map, problem.y).x, problem.c), 1e-12);
}

TEST(Nesta, AnswersZeroWhereZeroSatisfies) {
  Problem problem(901);
  const Recovered nothing = recover(Nesta{}, problem.map, std::vector<double>(20, 0.0));
  EXPECT_THAT(nothing.x, testing::Each(0.0));
  EXPECT_TRUE(nothing.converged);
  const double norm = vector_of(problem.y).norm();
  const Recovered loose = recover(Nesta{.eps = 1.01 * norm}, problem.map, problem.y);
  EXPECT_THAT(loose.x, testing::Each(0.0));
  EXPECT_NEAR(loose.residual, norm, 1e-12);
  EXPECT_EQ(loose.duality_gap, 0.0);
}

TEST(Nesta, SaysSoWhenIterationsRunOut) {
  Problem problem(902);
  const Recovered result = recover(Nesta{.max_iterations = 15}, problem.map, problem.y);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 15);
  EXPECT_LE(result.residual, 1e-12);
}

TEST(Nesta, RefusesRowsThatAreNotOrthonormal) {
  MatrixMap map({1.0, 1.0}, 1, 2);
  EXPECT_THROW(static_cast<void>(recover(Nesta{}, map, std::vector{1.0})), ContractViolation);
}

TEST(Shrink, HuberLiesBelowTheAbsoluteValueByAtMostHalfItsWidth) {
  Rng rng = rng_of(903);
  for (int i = 0; i < 1000; ++i) {
    const double mu = rng.uniform(0.01, 2.0), x = rng.uniform(-3.0, 3.0), h = 1e-6;
    EXPECT_LE(huber(x, mu), std::abs(x));
    EXPECT_GE(huber(x, mu), std::abs(x) - 0.5 * mu - 1e-15);
    EXPECT_NEAR(huber_gradient(x, mu), (huber(x + h, mu) - huber(x - h, mu)) / (2.0 * h), 1e-3);
  }
}

}  // namespace
}  // namespace cogslam
