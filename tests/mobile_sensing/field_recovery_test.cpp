#include "slam/mobile_sensing/field_recovery.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "slam/recover/total_variation.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/golden.hpp"

namespace cogslam {
namespace {

constexpr std::array<FieldPrior, 3> kPriors{FieldPrior::kHaar, FieldPrior::kDct, FieldPrior::kTotalVariation};
constexpr int kWidth = 21, kHeight = 13;  // neither a power of two

/// A room with a wall across it.
double room(std::uint32_t cell) {
  const int x = static_cast<int>(cell) % kWidth, y = static_cast<int>(cell) / kWidth;
  return x < 2 || y < 2 || x > 18 || y > 10 || (x > 9 && x < 12 && y < 7) ? 1.0 : 0.0;
}

CellSamples sampled(std::size_t count, std::uint32_t seed = 1) {
  return sense_random_cells(kWidth, kHeight, count, seed, room);
}

double l1_norm(const std::vector<double>& c) {
  double sum = 0.0;
  for (const double v : c) sum += std::abs(v);
  return sum;
}

/// Of the whole room, by the prior's own measure.
double objective_of_truth(FieldPrior prior) {
  std::vector<double> field;
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) field.push_back(room(i));
  if (prior == FieldPrior::kTotalVariation) return total_variation(field, kWidth);
  Basis basis(prior == FieldPrior::kHaar ? BasisKind::kHaar : BasisKind::kDct, kWidth, kHeight);
  std::vector<double> c(basis.size());
  basis.forward(field, c);
  return l1_norm(c);
}

double error_of(const RecoveredField& recovered) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < recovered.field.size(); ++i) sum += std::pow(recovered.field[i] - room(i), 2);
  return std::sqrt(sum);
}

TEST(FieldRecovery, NamesAreReadBack) {
  for (const FieldPrior prior : kPriors) EXPECT_EQ(field_prior(name_of(prior)), prior);
  EXPECT_EQ(field_prior("haar_1d"), std::nullopt);
}

TEST(FieldRecovery, AgreesWithItsSamplesAndProvesItsGap) {
  for (const FieldPrior prior : kPriors) {
    const CellSamples samples = sampled(80);
    const RecoveredField recovered = recover_field({.prior = prior}, samples);
    ASSERT_EQ(recovered.field.size(), samples.field_size());
    for (std::size_t i = 0; i < samples.cells.size(); ++i) {
      EXPECT_NEAR(recovered.field[samples.cells[i]], samples.values[i], 1e-12);
    }
    EXPECT_TRUE(recovered.solver.converged);
    EXPECT_LE(*recovered.solver.duality_gap, 1e-3);
    EXPECT_LE(recovered.objective * (1.0 - *recovered.solver.duality_gap), objective_of_truth(prior) * (1.0 + 1e-12))
        << name_of(prior) << ": no field with these samples costs less";
  }
}

TEST(FieldRecovery, IsExactWhereEveryCellIsSampled) {
  for (const FieldPrior prior : kPriors) {
    const RecoveredField recovered = recover_field({.prior = prior}, sampled(kWidth * kHeight));
    EXPECT_LE(error_of(recovered), 1e-12) << name_of(prior);
    // Only a padded canvas leaves a choice: of what to put there.
    const double truth = objective_of_truth(prior);
    if (prior != FieldPrior::kHaar) EXPECT_NEAR(recovered.objective, truth, 1e-9 * truth) << name_of(prior);
  }
}

TEST(FieldRecovery, GetsBetterOnAverageWithMoreCells) {
  for (const FieldPrior prior : kPriors) {
    double before = HUGE_VAL;
    for (const std::size_t count : {30, 90, 180, 270}) {
      double sum = 0.0;
      for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        sum += error_of(recover_field({.prior = prior}, sampled(count, seed)));
      }
      EXPECT_LT(sum, before) << name_of(prior) << ", K = " << count;
      before = sum;
    }
  }
}

// The canvas of 21 x 13 cells has 32 x 16. If its padding were taken for samples of 0, the constant field that samples
// of 1 ask for would cost its steps at the border; unknown, it is one coefficient.
TEST(FieldRecovery, TakesPaddingForUnknownCells) {
  const auto one = [](std::uint32_t) { return 1.0; };
  const CellSamples samples = sense_random_cells(kWidth, kHeight, kWidth * kHeight, 1, one);
  const RecoveredField recovered = recover_field({.prior = FieldPrior::kHaar}, samples);
  ASSERT_EQ(recovered.solver.x.size(), 32U * 16U);
  EXPECT_NEAR(recovered.objective, std::sqrt(32.0 * 16.0), 1.1e-3 * std::sqrt(32.0 * 16.0));
  Basis canvas(BasisKind::kHaar, 32, 16);
  std::vector<double> whole(32 * 16);
  canvas.inverse(recovered.solver.x, whole);
  EXPECT_NEAR(whole.back(), 1.0, 0.05) << "the padding goes on as the field ends";
}

// Below, each sampled 1 stands alone, and the cheapest explanation of it is itself: 2 / 2^level per level.
TEST(FieldRecovery, ByHaarDoesNotBridgeIsolatedSamples) {
  const auto dot = [](std::uint32_t cell) { return cell == 5 * 32 + 9 ? 1.0 : 0.0; };
  CellSamples samples{.width = 32, .height = 32, .cells = {5 * 32 + 9}, .values = {1.0}};
  const RecoveredField alone = recover_field({.prior = FieldPrior::kHaar, .stop_at_gap = 1e-6}, samples);
  EXPECT_NEAR(alone.objective, 2.0, 1e-5) << "three details of the finest level tie at 1/2 each";
  samples = sense_random_cells(32, 32, 1024, 1, dot);
  EXPECT_NEAR(recover_field({.prior = FieldPrior::kHaar}, samples).field[5 * 32 + 9], 1.0, 1e-9);
}

TEST(FieldRecovery, SaysWhatSamplesLack) {
  CellSamples samples = sampled(30);
  samples.values.pop_back();
  EXPECT_EQ(error_text([&] { static_cast<void>(recover_field({}, samples)); }),
            "29 samples for the 30 cells asked for, expected one each");
  EXPECT_EQ(error_text([&] { static_cast<void>(recover_field({}, sampled(0))); }),
            "no cell was sensed, expected at least one");
}

TEST(FieldRecovery, ReachesTheGapOnTheReferenceHallway) {
  SKIP_WITHOUT_GOLDEN();
  const std::vector<double> map = golden::read("maps/hallway154x249_tri.csv");
  ASSERT_EQ(map.size(), 154U * 249U);
  const CellSamples samples = sense_random_cells(249, 154, 3000, 1, [&](std::uint32_t cell) { return map[cell]; });
  for (const FieldPrior prior : {FieldPrior::kHaar, FieldPrior::kTotalVariation}) {
    const RecoveredField recovered = recover_field({.prior = prior}, samples);
    EXPECT_TRUE(recovered.solver.converged) << name_of(prior);
    EXPECT_LE(recovered.solver.iterations, 2000) << name_of(prior);
  }
}

}  // namespace
}  // namespace cogslam
