#include "slam/map/coefficient_map.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "core/rng.hpp"
#include "slam/map/log_odds.hpp"
#include "slam/map/store.hpp"
#include "tests/support/slow_haar.hpp"
#include "tests/support/slow_top_m.hpp"

namespace cogslam {
namespace {

GridFrame area_of(int width, int height) {
  return {.cell_size = 0.1, .lattice_min = {-7, -3}, .width = width, .height = height};
}

Rng test_rng(std::uint32_t entity) { return Rng({.seed = 45, .purpose = Purpose::kWorld, .entity = entity}); }

/// Adds random changes to the loaded grid of a map and commits it; returns the changes. All cells change: a block of
/// which one cell alone differs from 0 has coefficients of equal magnitude, whose order is a matter of rounding.
std::vector<float> change_randomly(CoefficientMap& map, Rng& rng, CoefficientScratch& scratch) {
  Grid<float> grid;
  map.load(grid, scratch);
  std::vector<float> changes(grid.values().size(), 0.0F);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    changes[i] = static_cast<float>(rng.uniform(-0.4, 0.8));
    grid.values()[i] += changes[i];
  }
  map.commit(grid, scratch);
  return changes;
}

std::vector<float> loaded(const CoefficientMap& map) {
  Grid<float> grid;
  CoefficientScratch scratch;
  map.load(grid, scratch);
  return grid.values();
}

/// The basis of a canvas as a matrix: the columns of Phi in eq. (14), each a Haar function.
Eigen::MatrixXd haar_basis(const HaarCanvas& canvas) {
  Eigen::MatrixXd phi(canvas.size(), canvas.size());
  for (int row = 0; row < canvas.height; ++row) {
    for (int column = 0; column < canvas.width; ++column) {
      const std::vector<double> image = slow::haar_function(canvas.width, canvas.height, column, row);
      phi.col(row * canvas.width + column) = Eigen::Map<const Eigen::VectorXd>(image.data(), phi.rows());
    }
  }
  return phi;
}

/// H of eq. (15): a row with a single 1 for each of the m largest coefficients.
Eigen::MatrixXd selection_matrix(const Eigen::VectorXd& c, std::size_t m) {
  const std::vector<float> coefficients(c.data(), c.data() + c.size());
  const CoefficientCode code = slow::sort_and_keep(coefficients, m);
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(code.size()), c.size());
  for (std::size_t i = 0; i < code.size(); ++i) h(static_cast<Eigen::Index>(i), code.indices[i]) = 1.0;
  return h;
}

/// Eq. (22) in dense matrices on a map that fills its canvas: y = H [H_r y' + Phi^T (alpha - beta)], H_r = H^T.
TEST(CoefficientMap, FollowsEquation22OnAFullCanvas) {
  const GridFrame area = area_of(4, 8);
  const HaarCanvas canvas = HaarCanvas::covering(4, 8);
  const Eigen::MatrixXd phi = haar_basis(canvas);
  for (std::uint32_t round = 0; round < 20; ++round) {
    Rng rng = test_rng(round);
    CoefficientMap map(area, 50.0, std::make_shared<MemoryMeter>());
    CoefficientScratch scratch;
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(1, 32);
    Eigen::VectorXd y = Eigen::VectorXd::Zero(1);
    for (int step = 0; step < 10; ++step) {
      const std::vector<float> changes = change_randomly(map, rng, scratch);
      const Eigen::VectorXd alpha = Eigen::Map<const Eigen::VectorXf>(changes.data(), 32).cast<double>();
      const Eigen::VectorXd c = h.transpose() * y + phi.transpose() * alpha;
      h = selection_matrix(c, 16);
      y = h * c;
      const Eigen::VectorXd expected = phi * h.transpose() * y;
      const std::vector<float> values = loaded(map);
      for (int i = 0; i < 32; ++i) ASSERT_NEAR(values[static_cast<std::size_t>(i)], expected[i], 1e-5);
    }
  }
}

/// The same on a padded canvas. What truncation lets leak into the padding is dropped at each load, since the padding
/// is unknown by definition: eq. (22) with the bracket Phi^T P (m + alpha - beta), P the projection onto map cells.
TEST(CoefficientMap, FollowsEquation22OnAPaddedCanvas) {
  const HaarCanvas canvas = HaarCanvas::covering(5, 3);
  const Eigen::MatrixXd phi = haar_basis(canvas);
  Rng rng = test_rng(100);
  CoefficientMap map(area_of(5, 3), 40.0, std::make_shared<MemoryMeter>());
  CoefficientScratch scratch;
  Eigen::VectorXd m = Eigen::VectorXd::Zero(32);
  int compared = 0;
  for (int step = 0; step < 40; ++step) {
    const std::vector<float> changes = change_randomly(map, rng, scratch);
    for (int i = 0; i < 15; ++i) m[i / 5 * 8 + i % 5] += changes[static_cast<std::size_t>(i)];
    const Eigen::VectorXd c = phi.transpose() * m;
    const Eigen::MatrixXd h = selection_matrix(c, 6);  // 40 % of 15 cells
    const Eigen::VectorXd back = phi * h.transpose() * h * c;
    // Blocks that the map's edge cuts have coefficients of equal magnitude: which of them is kept says nothing.
    Eigen::VectorXd sizes = c.cwiseAbs();
    std::sort(sizes.data(), sizes.data() + sizes.size(), std::greater<>());
    const bool clear_choice = sizes[5] - sizes[6] > 1e-4;
    compared += clear_choice ? 1 : 0;
    m.setZero();
    const std::vector<float> values = loaded(map);
    for (int i = 0; i < 15; ++i) {
      const float value = values[static_cast<std::size_t>(i)];
      m[i / 5 * 8 + i % 5] = value;
      if (clear_choice) {
        ASSERT_NEAR(value, back[i / 5 * 8 + i % 5], 1e-5) << "step " << step;
      }
    }
  }
  EXPECT_GT(compared, 10);
}

/// Up to float rounding: 40 commits of values up to 3.2 on a 128 x 64 canvas, 14 sums of two per value and commit.
TEST(CoefficientMap, EqualsTheDenseMapAtAHundredPercentOfAFullCanvas) {
  const GridFrame area = area_of(128, 64);
  const auto meter = std::make_shared<MemoryMeter>();
  MapStore dense({}, 0.1, area, meter);
  MapStore coefficients({.kind = StoreKind::kCoefficients, .percent_kept = 100.0}, 0.1, area, meter);
  MapScratch a, b;
  Rng rng = test_rng(200);
  const LogOddsModel model;
  const Cell low = area.lattice_min;
  for (int step = 0; step < 40; ++step) {
    const CellWindow part = intersection(
        window_of(area), {{low.x + static_cast<int>(rng.below(128)), low.y + static_cast<int>(rng.below(64))},
                          {low.x + 127, low.y + 40 + static_cast<int>(rng.below(30))}});
    if (part.empty()) continue;
    dense.load(part, a);
    coefficients.load(part, b);
    for (int y = part.min.y; y <= part.max.y; ++y) {
      for (int x = part.min.x; x <= part.max.x; ++x) {
        const float change = rng.below(2) == 0 ? model.hit : model.free;
        const Cell in_a{x - part.min.x, y - part.min.y}, in_b{x - low.x, y - low.y};
        a.log_odds[in_a] = model.after(a.log_odds[in_a], change);
        b.log_odds[in_b] = model.after(b.log_odds[in_b], change);
      }
    }
    dense.commit(part, a);
    coefficients.commit(part, b);
  }
  dense.load(window_of(area), a);
  coefficients.load(window_of(area), b);
  ASSERT_EQ(a.log_odds.frame(), b.log_odds.frame());
  for (std::size_t i = 0; i < area.size(); ++i) ASSERT_NEAR(a.log_odds.values()[i], b.log_odds.values()[i], 1e-4);
}

TEST(CoefficientMap, LosesNoMoreThanTheSquaresItDrops) {
  for (const auto& [width, height] : {std::pair{16, 8}, {13, 7}, {40, 46}}) {
    for (const double percent : {5.0, 40.0, 80.0}) {
      Rng rng = test_rng(300 + static_cast<std::uint32_t>(width + percent));
      CoefficientMap map(area_of(width, height), percent, std::make_shared<MemoryMeter>());
      CoefficientScratch scratch;
      const std::vector<float> values = change_randomly(map, rng, scratch);
      const HaarCanvas canvas = HaarCanvas::covering(width, height);
      std::vector<float> image = slow::padded(values, width, height, canvas.width, canvas.height);
      slow::haar_rows_then_columns(canvas.width, canvas.height, image);
      std::sort(image.begin(), image.end(), [](float a, float b) { return std::abs(a) > std::abs(b); });
      double dropped = 0.0, error = 0.0;
      for (std::size_t i = kept_count(canvas.cells(), percent); i < image.size(); ++i) dropped += image[i] * image[i];
      const std::vector<float> back = loaded(map);
      for (std::size_t i = 0; i < values.size(); ++i) error += std::pow(values[i] - back[i], 2);
      EXPECT_LE(error, dropped * (1.0 + 1e-4));
      EXPECT_GT(error, 0.0);
      if (canvas.cells() == canvas.size()) {
        EXPECT_NEAR(error, dropped, 1e-4 * dropped);  // Parseval
      }
    }
  }
}

TEST(CoefficientMap, CountsPercentOfItsCellsAndNotOfItsCanvas) {
  Rng rng = test_rng(400);
  CoefficientScratch scratch;
  CoefficientMap map(area_of(5, 3), 40.0, std::make_shared<MemoryMeter>());  // 15 cells on a canvas of 32
  EXPECT_EQ(map.coefficients(), 0U);
  change_randomly(map, rng, scratch);
  EXPECT_EQ(map.coefficients(), 6U);
  CoefficientMap room(area_of(40, 46), 40.0, std::make_shared<MemoryMeter>());  // 1840 cells on a canvas of 4096
  change_randomly(room, rng, scratch);
  EXPECT_EQ(room.coefficients(), 736U);
}

TEST(CoefficientMap, IsUnknownBeforeTheFirstCommit) {
  const CoefficientMap map(area_of(9, 4), 40.0, std::make_shared<MemoryMeter>());
  EXPECT_THAT(loaded(map), testing::AllOf(testing::SizeIs(36), testing::Each(0.0F)));
  EXPECT_EQ(map.extent(), (CellWindow{{-7, -3}, {1, 0}}));
}

TEST(CoefficientMap, SharesItsCodeWithCopiesUntilTheyCommit) {
  const auto meter = std::make_shared<MemoryMeter>();
  {
    Rng rng = test_rng(500);
    CoefficientScratch scratch;
    CoefficientMap first(area_of(40, 46), 40.0, meter);
    EXPECT_EQ(meter->payload(), 0);
    change_randomly(first, rng, scratch);
    EXPECT_EQ(meter->payload(), 736 * 8);
    const std::int64_t alone = meter->total();
    EXPECT_GT(alone, meter->payload());
    const std::vector<float> before = loaded(first);
    CoefficientMap second = first;
    EXPECT_EQ(meter->total(), alone);
    change_randomly(second, rng, scratch);
    EXPECT_EQ(meter->payload(), 2 * 736 * 8);
    EXPECT_EQ(meter->total(), 2 * alone);
    EXPECT_EQ(loaded(first), before);
    EXPECT_NE(loaded(second), before);
    first = second;
    EXPECT_EQ(meter->total(), alone);
  }
  EXPECT_EQ(meter->payload(), 0);
  EXPECT_EQ(meter->total(), 0);
}

}  // namespace
}  // namespace cogslam
