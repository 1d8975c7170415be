#include "eval/metrics/map_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

constexpr TruthCell kF = TruthCell::kFree, kO = TruthCell::kOccupied, kU = TruthCell::kUnobservable;

template <class T>
Grid<T> grid(GridFrame frame, std::vector<T> values) {
  Grid<T> g(frame);
  EXPECT_EQ(g.values().size(), values.size());
  g.values() = std::move(values);
  return g;
}

double probability(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

GridFrame random_frame(Rng& rng) {
  const auto any = [&](std::uint32_t n) { return static_cast<int>(rng.below(n)); };
  return {.cell_size = 0.2, .lattice_min = {any(9) - 4, any(9) - 4}, .width = 1 + any(8), .height = 1 + any(8)};
}

Grid<TruthCell> random_truth(Rng& rng) {
  Grid<TruthCell> truth(random_frame(rng));
  for (TruthCell& c : truth.values()) c = static_cast<TruthCell>(rng.below(3));
  truth.values().front() = kF;
  return truth;
}

Grid<float> random_estimate(Rng& rng) {
  Grid<float> estimate(random_frame(rng));
  for (float& l : estimate.values()) l = static_cast<float>(3.0 * rng.normal());
  return estimate;
}

TEST(MapError, IsTheMeanOfSquaresByHand) {
  const GridFrame frame{.cell_size = 0.5, .lattice_min = {-1, 2}, .width = 2, .height = 2};
  const auto error = map_error(grid<TruthCell>(frame, {kF, kO, kU, kF}), grid<float>(frame, {-1.0F, 1.0F, 2.0F, 0.0F}));
  ASSERT_TRUE(error);
  const double p1 = probability(-1.0), p2 = probability(1.0), p3 = probability(2.0);
  EXPECT_EQ(error->observable, 3U);
  EXPECT_EQ(error->all, 4U);
  const double observable = p1 * p1 + (1 - p2) * (1 - p2) + 0.25;
  EXPECT_NEAR(error->mse, observable / 3, 1e-12);
  EXPECT_NEAR(error->mse_all, (observable + (p3 - 0.5) * (p3 - 0.5)) / 4, 1e-12);
  EXPECT_NEAR(error->mse_logodds, (1.0 * 1.0 + 2.2 * 2.2 + 2.0 * 2.0 + 2.0 * 2.0) / 4, 1e-12);
  EXPECT_NEAR(error->log_score, -(std::log(1 - p1) + std::log(p2) + std::log(0.5)) / 3, 1e-12);
}

TEST(MapError, CountsTruthAgainstBelief) {
  const GridFrame frame{.width = 7, .height = 1};
  const auto error = map_error(grid<TruthCell>(frame, {kF, kF, kF, kO, kO, kO, kU}),
                               grid<float>(frame, {-1.0F, 0.0F, 1.0F, 1.0F, 1.0F, -1.0F, 1.0F}));
  const std::array<std::array<std::size_t, 3>, 2> expected{{{1, 1, 1}, {1, 0, 2}}};
  EXPECT_EQ(error->confusion, expected);
}

TEST(MapError, ClassesChangeAtTheStatedProbabilities) {
  const auto log_odds = [](double p) { return std::log(p / (1 - p)); };
  EXPECT_EQ(classify(log_odds(0.349)), CellClass::kFree);
  EXPECT_EQ(classify(log_odds(0.351)), CellClass::kUnknown);
  EXPECT_EQ(classify(0.0), CellClass::kUnknown);
  EXPECT_EQ(classify(log_odds(0.649)), CellClass::kUnknown);
  EXPECT_EQ(classify(log_odds(0.651)), CellClass::kOccupied);
}

TEST(MapError, DoesNotRewardGoingBeyondTheScoredBounds) {
  const GridFrame frame{.width = 2, .height = 1};
  const auto truth = grid<TruthCell>(frame, {kF, kO});
  const auto timid = map_error(truth, grid<float>(frame, {-2.0F, 3.2F}));
  const auto bold = map_error(truth, grid<float>(frame, {-99.0F, std::numeric_limits<float>::infinity()}));
  EXPECT_NEAR(bold->mse, timid->mse, 1e-6);
  EXPECT_NEAR(bold->log_score, timid->log_score, 1e-6);
  EXPECT_EQ(bold->mse_logodds, 0.0);
}

TEST(MapError, ScoresUncoveredCellsAsUnknown) {
  const auto truth = grid<TruthCell>({.width = 2, .height = 1}, {kF, kO});
  const Grid<float> nothing(GridFrame{.lattice_min = {50, 50}, .width = 3, .height = 3}, 9.0F);
  const auto error = map_error(truth, nothing);
  EXPECT_EQ(error->mse, 0.25);
  EXPECT_EQ(error->mse_all, 0.25);
  EXPECT_NEAR(error->log_score, std::log(2.0), 1e-12);
  EXPECT_EQ(error->confusion[0][1] + error->confusion[1][1], 2U);
}

// The obvious twin: cells found by the position of their centres, sums kept per cell.
TEST(MapError, EqualsALookUpByPositionWhateverTheFrames) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Rng rng({.seed = seed});
    const auto truth = random_truth(rng);
    const auto estimate = random_estimate(rng);
    double mse = 0.0, mse_all = 0.0, n = 0.0;
    for (int y = 0; y < truth.frame().height; ++y) {
      for (int x = 0; x < truth.frame().width; ++x) {
        const Cell there = estimate.frame().cell_of(truth.frame().centre_of({x, y}));
        const double l = estimate.frame().contains(there) ? static_cast<double>(estimate[there]) : 0.0;
        const double p = probability(std::min(std::max(l, -2.0), 3.2));
        const TruthCell t = truth[{x, y}];
        const double goal = t == kF ? 0.0 : t == kO ? 1.0 : 0.5;
        mse_all += (p - goal) * (p - goal) / static_cast<double>(truth.frame().size());
        mse += t == kU ? 0.0 : (p - goal) * (p - goal);
        n += t == kU ? 0.0 : 1.0;
      }
    }
    const auto error = map_error(truth, estimate);
    EXPECT_NEAR(error->mse, mse / n, 1e-12) << "seed " << seed;
    EXPECT_NEAR(error->mse_all, mse_all, 1e-12) << "seed " << seed;
  }
}

TEST(MapError, StaysWithinItsBounds) {
  const double best_free = probability(kScoredLogOddsMin),
               worst = std::max(probability(kScoredLogOddsMax), 1 - best_free);
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Rng rng({.seed = seed, .entity = 1});
    const auto truth = random_truth(rng);
    const auto error = map_error(truth, random_estimate(rng));
    EXPECT_GE(error->mse, 0.0);
    EXPECT_LE(error->mse, worst * worst);
    EXPECT_LE(error->mse_logodds, 5.2 * 5.2);
    EXPECT_GT(error->log_score, 0.0);
    EXPECT_LE(error->log_score, -std::log(1 - probability(kScoredLogOddsMax)) + 1e-12);
    std::size_t counted = 0;
    for (const auto& row : error->confusion) counted += row[0] + row[1] + row[2];
    EXPECT_EQ(counted, error->observable);
  }
}

TEST(MapError, OfNothingObservableIsNotMeasured) {
  EXPECT_FALSE(map_error(Grid<TruthCell>({.width = 2, .height = 2}, kU), Grid<float>({.width = 2, .height = 2})));
  EXPECT_FALSE(map_error(Grid<TruthCell>{}, Grid<float>{}));
}

TEST(MapError, RejectsOtherCellSizesAndNaN) {
  const Grid<TruthCell> truth({.cell_size = 0.1, .width = 1, .height = 1}, kF);
  EXPECT_THROW((void)map_error(truth, Grid<float>({.cell_size = 0.2, .width = 1, .height = 1})), ContractViolation);
  const Grid<float> broken({.cell_size = 0.1, .width = 1, .height = 1}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW((void)map_error(truth, broken), ContractViolation);
}

TEST(MapDifference, IsTheMeanOfSquaresByHand) {
  const GridFrame frame{.width = 2, .height = 1};
  const auto difference = map_difference(frame, grid<float>(frame, {1.0F, 9.0F}), grid<float>(frame, {0.0F, 4.0F}));
  EXPECT_NEAR(*difference, std::pow(probability(1.0) - 0.5, 2) / 2, 1e-12);  // both 9 and 4 saturate
}

TEST(MapDifference, IsZeroOnTheMapItselfAndSymmetric) {
  Rng rng({.seed = 3});
  const auto a = random_estimate(rng), b = random_estimate(rng);
  const GridFrame area{.cell_size = 0.2, .lattice_min = {-6, -6}, .width = 20, .height = 20};
  EXPECT_EQ(*map_difference(area, a, a), 0.0);
  EXPECT_GT(*map_difference(area, a, b), 0.0);
  EXPECT_EQ(*map_difference(area, a, b), *map_difference(area, b, a));
  EXPECT_FALSE(map_difference(GridFrame{.cell_size = 0.2}, a, b));
}

}  // namespace
}  // namespace cogslam
