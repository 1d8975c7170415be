#include "slam/weight/likelihood_field.hpp"

#include <gmock/gmock.h>

#include "core/rng.hpp"
#include "tests/support/drawn_grid.hpp"

namespace cogslam {
namespace {

/// Slow twin: the distance from a point to the nearest sample of an occupied cell, by trying them all [m]. A cell has
/// `samples` x `samples` of them, in the middles of as many equal squares.
double distance_to_occupied(const Grid<float>& grid, int samples, const Eigen::Vector2d& p) {
  const GridFrame& frame = grid.frame();
  const double step = frame.cell_size / samples;
  double nearest = std::numeric_limits<double>::infinity();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (grid[{x, y}] <= kOccupiedLogOdds) continue;
      const Eigen::Vector2d corner = frame.origin() + frame.cell_size * Eigen::Vector2d(x, y);
      for (int n = 0; n < samples * samples; ++n) {
        nearest = std::min(nearest, (corner + step * Eigen::Vector2d(n % samples + 0.5, n / samples + 0.5) - p).norm());
      }
    }
  }
  return nearest;
}

Grid<float> random_grid(Rng& rng, double cell_size) {
  Grid<float> grid(GridFrame{.cell_size = cell_size, .lattice_min = {-4, 3}, .width = 12, .height = 9});
  for (float& value : grid.values())
    value = static_cast<float>(rng.below(12) == 0 ? rng.uniform(0.51, 3.2) : rng.uniform(-2.0, 0.49));
  return grid;
}

TEST(LikelihoodField, FallsOffWithTheDistanceToTheNearestOccupiedSample) {
  for (std::uint32_t round = 0; round < 30; ++round) {
    Rng rng({.seed = 49, .purpose = Purpose::kWorld, .entity = round});
    const double cell_size = std::array{0.02, 0.05, 0.1, 0.2, 0.4}[rng.below(5)];
    const LikelihoodFieldConfig config{.sigma = rng.uniform(0.03, 0.15), .finest_sample = 0.05};
    const Grid<float> grid = random_grid(rng, cell_size);
    LikelihoodField field(config, cell_size);
    field.draw(grid);
    EXPECT_LE(field.sample_size(), std::max(config.finest_sample, cell_size) + 1e-12);
    EXPECT_NEAR(std::remainder(cell_size, field.sample_size()), 0.0, 1e-9);
    const double sample = field.sample_size();
    const int samples = static_cast<int>(std::lround(cell_size / sample));
    // At samples, but for the outermost, where rounding decides between inside and outside of the window.
    for (int j = 1; j + 1 < std::lround(9 * cell_size / sample); ++j) {
      for (int i = 1; i + 1 < std::lround(12 * cell_size / sample); ++i) {
        const Eigen::Vector2d p = grid.frame().origin() + sample * Eigen::Vector2d(i + 0.5, j + 0.5);
        const double d = distance_to_occupied(grid, samples, p),
                     expected = std::exp(-0.5 * d * d / (config.sigma * config.sigma));
        if (d < 3.0 * config.sigma - 1e-9) {
          ASSERT_NEAR(field.at(p.x(), p.y()), expected, 2e-5) << "round " << round;
        } else {  // cut off, somewhere beyond 3 sigma
          ASSERT_LE(field.at(p.x(), p.y()), expected + 2e-5) << "round " << round;
        }
      }
    }
  }
}

TEST(LikelihoodField, IsBilinearBetweenItsSamples) {
  Rng rng({.seed = 49, .purpose = Purpose::kWorld, .entity = 100});
  const Grid<float> grid = random_grid(rng, 0.1);
  LikelihoodField field({.sigma = 0.07, .finest_sample = 0.05}, 0.1);
  field.draw(grid);
  const double sample = field.sample_size();
  for (int n = 0; n < 500; ++n) {
    const Eigen::Vector2d low =
        grid.frame().origin() + sample * Eigen::Vector2d(rng.below(18) + 1.5, rng.below(12) + 1.5);
    const double fx = rng.uniform(0.01, 0.99), fy = rng.uniform(0.01, 0.99);
    const auto at = [&](double i, double j) { return field.at(low.x() + i * sample, low.y() + j * sample); };
    const double expected =
        (1 - fy) * ((1 - fx) * at(0, 0) + fx * at(1, 0)) + fy * ((1 - fx) * at(0, 1) + fx * at(1, 1));
    ASSERT_NEAR(at(fx, fy), expected, 1e-5);
  }
}

TEST(LikelihoodField, IsFlatInsideALargeOccupiedCell) {
  const Grid<float> grid = drawn_grid({"...", ".#.", "..."}, 1.0);
  LikelihoodField field(LikelihoodFieldConfig{}, 1.0);
  field.draw(grid);
  for (const double x : {1.03, 1.3, 1.5, 1.97}) EXPECT_NEAR(field.at(x, 1.5), 1.0, 1e-6);
  EXPECT_NEAR(field.at(0.5, 1.5), 0.0, 1e-4);
}

TEST(LikelihoodField, IsZeroOutsideItsWindowAndEmptyWithoutAnOccupiedCell) {
  LikelihoodField field(LikelihoodFieldConfig{}, 0.1);
  field.draw(drawn_grid({"###", "###"}, 0.1));
  EXPECT_FALSE(field.empty());
  EXPECT_NEAR(field.at(0.15, 0.1), 1.0, 1e-6);
  for (const double far : {-10.0, -0.01, 0.31, 10.0}) EXPECT_EQ(field.at(far, 0.1), 0.0F);
  field.draw(drawn_grid({". .", "..."}, 0.1));
  EXPECT_TRUE(field.empty());
  EXPECT_EQ(field.at(0.15, 0.1), 0.0F);
}

/// The margin that the map must be loaded with: cells beyond it change nothing inside.
TEST(LikelihoodField, LooksNoFartherThanItsMargin) {
  for (const double cell_size : {0.05, 0.1, 0.5}) {
    LikelihoodField field({.sigma = 0.08, .finest_sample = 0.05}, cell_size);
    const int far = field.margin_cells() + 1, side = 2 * far + 1;
    Grid<float> grid(GridFrame{.cell_size = cell_size, .width = side, .height = side}, -1.0F);
    for (int i = 0; i < side; ++i) grid[{i, 0}] = grid[{i, side - 1}] = grid[{0, i}] = grid[{side - 1, i}] = 2.0F;
    field.draw(grid);
    for (const double share : {0.01, 0.5, 0.99}) {
      EXPECT_EQ(field.at((far + share) * cell_size, (far + 0.5) * cell_size), 0.0F);
      EXPECT_EQ(field.at((far + 0.5) * cell_size, (far + share) * cell_size), 0.0F);
    }
  }
}

}  // namespace
}  // namespace cogslam
