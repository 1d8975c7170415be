#include "slam/recover/total_variation.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/check.hpp"
#include "tests/support/random_measurements.hpp"
#include "tests/support/slow_recover.hpp"

namespace cogslam {
namespace {

using namespace test;

TEST(TotalVariationNorm, EqualsEquation11CellByCell) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng = rng_of(seed);
    const std::size_t width = 1 + rng.below(9), height = 1 + rng.below(9);
    const std::vector<double> map = normal_vector(width * height, rng);
    const double expected = slow::total_variation(map, width);
    EXPECT_NEAR(total_variation(map, width), expected, 1e-13 * (1.0 + expected));
  }
}

TEST(TotalVariationNorm, CountsTheCornerOfOneCellOnce) {
  // Differences to the cells before: the raised cell sees both of its own, the two after it one each.
  EXPECT_NEAR(total_variation(std::vector{0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 3), 2.0 + std::sqrt(2.0),
              1e-15);
  EXPECT_NEAR(total_variation(std::vector{1.0, 0.0, 0.0, 0.0}, 2), 2.0, 1e-15);
}

TEST(TotalVariation, KeepsSamplesAndTheirRangeAndBoundsEveryOtherMap) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng = rng_of(100 + seed);
    const std::size_t width = 2 + rng.below(9), height = 2 + rng.below(9), n = width * height;
    const std::vector<std::size_t> cells = random_entries(1 + rng.below(static_cast<std::uint32_t>(n)), n, rng);
    MatrixMap a = selection_of(cells, n);
    const std::vector<double> truth = normal_vector(n, rng);
    const std::vector<double> y = measured(a, truth);
    const Recovered result = recover(TotalVariation{width, height}, a, y);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(*result.duality_gap, 1e-3);
    EXPECT_EQ(result.residual, 0.0);
    EXPECT_GE(*std::ranges::min_element(result.x), *std::ranges::min_element(y));
    EXPECT_LE(*std::ranges::max_element(result.x), *std::ranges::max_element(y));
    const double bound = total_variation(result.x, width) * (1.0 - *result.duality_gap);
    EXPECT_LE(bound, total_variation(truth, width) + 1e-12);
    std::vector<double> other = result.x;
    for (double& v : other) v += 0.01 * rng.normal();
    for (std::size_t k = 0; k < cells.size(); ++k) other[cells[k]] = y[k];
    EXPECT_LE(bound, total_variation(other, width) + 1e-12);
  }
}

TEST(TotalVariation, OfOneRowIsTheSumOfStepsBetweenSamples) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(200 + seed);
    std::vector<std::size_t> cells = random_entries(5, 30, rng);
    std::ranges::sort(cells);
    MatrixMap a = selection_of(cells, 30);
    const std::vector<double> y = normal_vector(5, rng);
    double expected = 0.0;
    for (std::size_t k = 1; k < 5; ++k) expected += std::abs(y[k] - y[k - 1]);
    for (const TotalVariation& tv : {TotalVariation{30, 1}, TotalVariation{1, 30}}) {
      const Recovered result = recover(tv, a, y);
      EXPECT_NEAR(total_variation(result.x, tv.width), expected, 1.1e-3 * expected);
    }
  }
}

// Two unknown cells in a 3 x 3 map: all values of both, finely.
TEST(TotalVariation, IsWithinItsGapOfTheBestOnAGrid) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Rng rng = rng_of(300 + seed);
    std::vector<std::size_t> cells = random_entries(9, 9, rng);
    const std::size_t u = cells[7], v = cells[8];
    cells.resize(7);
    MatrixMap a = selection_of(cells, 9);
    std::vector<double> map(9);
    for (double& value : map) value = rng.uniform();
    const std::vector<double> y = measured(a, map);
    const Recovered result = recover(TotalVariation{3, 3, 1e-6}, a, y);
    double best = HUGE_VAL;
    for (int i = 0; i <= 200; ++i) {
      for (int j = 0; j <= 200; ++j) {
        map[u] = i / 200.0;
        map[v] = j / 200.0;
        best = std::min(best, slow::total_variation(map, 3));
      }
    }
    const double found = total_variation(result.x, 3);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(found, best * (1.0 + 1.1e-6));
    EXPECT_GE(found, best - 4.0 * 2.0 * 0.0025);  // no cell is more than 0.0025 from the grid, and enters three terms
  }
}

TEST(TotalVariation, ScalesAndShiftsWithItsData) {
  Rng rng = rng_of(400);
  const std::vector<std::size_t> cells = random_entries(20, 64, rng);
  MatrixMap a = selection_of(cells, 64);
  std::vector<double> y = normal_vector(20, rng);
  const std::vector<double> plain = recover(TotalVariation{8, 8}, a, y).x;
  for (double& v : y) v = 1000.0 * v - 500.0;
  const std::vector<double> scaled = recover(TotalVariation{8, 8}, a, y).x;
  for (std::size_t i = 0; i < 64; ++i) EXPECT_NEAR(scaled[i], 1000.0 * plain[i] - 500.0, 1e-6);
}

TEST(TotalVariation, OfEqualSamplesIsConstant) {
  const std::vector<std::size_t> cells = {3, 7};
  MatrixMap a = selection_of(cells, 12);
  const Recovered result = recover(TotalVariation{4, 3}, a, std::vector{0.4, 0.4});
  EXPECT_THAT(result.x, testing::Each(0.4));
  EXPECT_EQ(result.duality_gap, 0.0);
  EXPECT_TRUE(result.converged);
}

TEST(TotalVariation, SaysSoWhenIterationsRunOut) {
  Rng rng = rng_of(500);
  MatrixMap a = selection_of(random_entries(20, 64, rng), 64);
  const Recovered result =
      recover(TotalVariation{.width = 8, .height = 8, .max_iterations = 3}, a, normal_vector(20, rng));
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 3);
  EXPECT_GT(*result.duality_gap, 1e-3);
}

TEST(TotalVariation, RefusesMapsThatMixCellsAndWrongShapes) {
  MatrixMap mixing({0.6, 0.8}, 1, 2);
  EXPECT_THROW(static_cast<void>(recover(TotalVariation{2, 1}, mixing, std::vector{1.0})), ContractViolation);
  MatrixMap picking({0.0, 1.0}, 1, 2);
  EXPECT_THROW(static_cast<void>(recover(TotalVariation{3, 1}, picking, std::vector{1.0})), ContractViolation);
}

}  // namespace
}  // namespace cogslam
