#include "slam/mobile_sensing/cell_samples.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

/// A field that tells cells apart.
double sensed(std::uint32_t cell) { return 0.5 + cell; }

TEST(CellSamples, PhiPicksTheSampledCellsAndItsTransposeScattersThem) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng({seed, Purpose::kCompression, 5, 0});
    const int width = 1 + static_cast<int>(rng.below(9)), height = 1 + static_cast<int>(rng.below(9));
    const std::uint32_t n = static_cast<std::uint32_t>(width * height);
    const CellSamples samples = sense_random_cells(width, height, 1 + rng.below(n), seed, sensed);
    Compressor phi = selection_of(samples);
    ASSERT_TRUE(phi.is_selection() && phi.orthonormal_rows());
    std::vector<double> m(n), y(samples.cells.size()), picked(y.size()), scattered(n);
    for (double& v : m) v = rng.normal();
    for (double& v : y) v = rng.normal();
    phi.apply(m, picked);
    phi.apply_transpose(y, scattered);
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_EQ(picked[i], m[samples.cells[i]]);
    EXPECT_NEAR(std::inner_product(y.begin(), y.end(), picked.begin(), 0.0),
                std::inner_product(m.begin(), m.end(), scattered.begin(), 0.0), 1e-12)
        << "adjoint";
  }
}

TEST(CellSamples, AreMutuallyExcludedAndSayWhatWasSensed) {
  const CellSamples samples = sense_random_cells(11, 7, 40, 3, sensed);
  EXPECT_EQ(std::set<std::uint32_t>(samples.cells.begin(), samples.cells.end()).size(), 40U);
  EXPECT_THAT(samples.cells, testing::Each(testing::Lt(77U)));
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(samples.values[i], sensed(samples.cells[i]));
}

TEST(CellSamples, OfOneSeedAreNestedAndAllAreAllCells) {
  const CellSamples few = sense_random_cells(11, 7, 20, 3, sensed), all = sense_random_cells(11, 7, 77, 3, sensed);
  EXPECT_TRUE(std::equal(few.cells.begin(), few.cells.end(), all.cells.begin()));
  EXPECT_EQ(std::set<std::uint32_t>(all.cells.begin(), all.cells.end()).size(), 77U);
  EXPECT_NE(few.cells, sense_random_cells(11, 7, 20, 4, sensed).cells);
}

// 2000 draws of 10 in 40 cells: each cell 500 times, standard deviation below 19.4.
TEST(CellSamples, AreDrawnUniformly) {
  std::vector<int> drawn(40, 0);
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    for (const std::uint32_t cell : sense_random_cells(8, 5, 10, seed, sensed).cells) ++drawn[cell];
  }
  for (const int count : drawn) EXPECT_NEAR(count, 500, 4 * 19.4);
}

TEST(CellSamples, RefusesMoreCellsThanThereAre) {
  EXPECT_THROW(static_cast<void>(sense_random_cells(3, 2, 7, 1, sensed)), ContractViolation);
  EXPECT_THROW(static_cast<void>(sense_cells(3, 2, {6}, sensed)), ContractViolation);
}

}  // namespace
}  // namespace cogslam
