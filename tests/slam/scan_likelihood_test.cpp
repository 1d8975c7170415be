#include "slam/weight/scan_likelihood.hpp"

#include <gmock/gmock.h>

#include "tests/support/drawn_grid.hpp"
#include "tests/support/mapped_room.hpp"
#include "tests/support/pose_scores.hpp"

namespace cogslam {
namespace {

constexpr Pose2 kTruePose{-0.4, -0.7, 0.6};

class ScanLikelihoodOf : public testing::TestWithParam<ScanModel> {};

TEST_P(ScanLikelihoodOf, IsHigherAtTheTruePoseThanAtShiftedOnes) {
  for (const double cell_size : {0.05, 0.1}) {
    const Grid<float> room = mapped_cornered_room(cell_size);
    ScanLikelihood likelihood({.model = GetParam()}, cell_size);
    likelihood.look_at(room);
    const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), kTruePose, 720));
    const double at_truth = likelihood.log_likelihood(probes, kTruePose);
    for (int direction = 0; direction < 16; ++direction) {
      const double angle = direction * std::numbers::pi / 8.0;
      for (const double shift : {2.0 * cell_size, 0.3, 0.6}) {
        const Pose2 shifted{kTruePose.x + shift * std::cos(angle), kTruePose.y + shift * std::sin(angle),
                            kTruePose.theta};
        EXPECT_GT(at_truth, likelihood.log_likelihood(probes, shifted) + 1.0) << shift << " m towards " << angle;
      }
    }
    for (const double turn : {-0.5, -0.1, 0.1, 0.5}) {
      EXPECT_GT(at_truth, likelihood.log_likelihood(probes, {kTruePose.x, kTruePose.y, kTruePose.theta + turn}) + 1.0);
    }
  }
}

TEST_P(ScanLikelihoodOf, GrowsInProportionToTheEffectiveBeams) {
  const Grid<float> room = mapped_cornered_room(0.1);
  ScanLikelihood one({.model = GetParam(), .effective_beams = 1.0}, 0.1);
  ScanLikelihood many({.model = GetParam(), .effective_beams = 37.0}, 0.1);
  one.look_at(room);
  many.look_at(room);
  const std::vector<Beam> probes = one.probes_of(clean_sweep(cornered_room(), kTruePose, 360));
  for (const Pose2& pose : {kTruePose, Pose2{0.0, -1.0, 2.0}}) {
    EXPECT_NEAR(many.log_likelihood(probes, pose), 37.0 * one.log_likelihood(probes, pose), 1e-9);
  }
  EXPECT_LT(one.log_likelihood(probes, kTruePose), 0.0);
}

TEST_P(ScanLikelihoodOf, GivesNoCreditForAMapWithoutObstacles) {
  ScanLikelihood likelihood({.model = GetParam()}, 0.1);
  const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), kTruePose, 90));
  const Grid<float> room = mapped_cornered_room(0.1);
  likelihood.look_at(room);
  const double mapped = likelihood.log_likelihood(probes, kTruePose);
  Grid<float> nothing = room;
  for (float& value : nothing.values()) value = 0.0F;
  likelihood.look_at(nothing);
  const double unknown = likelihood.log_likelihood(probes, kTruePose);
  for (float& value : nothing.values()) value = -2.0F;
  likelihood.look_at(nothing);
  const double free = likelihood.log_likelihood(probes, kTruePose);
  EXPECT_GT(mapped, unknown);
  EXPECT_GT(unknown, free);
}

TEST_P(ScanLikelihoodOf, SaysNothingWithoutProbes) {
  ScanLikelihood likelihood({.model = GetParam()}, 0.1);
  const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), kTruePose, 90));
  const Grid<float> room = mapped_cornered_room(0.1);
  likelihood.look_at(room);
  EXPECT_EQ(likelihood.log_likelihood({}, kTruePose), 0.0);
  EXPECT_NE(likelihood.log_likelihood(probes, kTruePose), 0.0);
}

TEST_P(ScanLikelihoodOf, GivesUnknownCellsTheirStatedValue) {
  // A wall far from the beam, which runs and ends in unknown cells.
  const Grid<float> map = drawn_grid({"#         ", "          ", "          ", "          ", "          "}, 1.0);
  const ScanLikelihoodConfig config{
      .model = GetParam(), .effective_beams = 1.0, .hit_share = 0.8, .unknown_value = 0.4};
  ScanLikelihood likelihood(config, 1.0);
  likelihood.look_at(map);
  const std::vector<Beam> probe{{.origin = {0.0, 0.0}, .end = {3.0, 0.0}, .range = 3.0F, .hit = true}};
  EXPECT_NEAR(likelihood.log_likelihood(probe, {5.5, 1.5, 0.0}), std::log(0.8 * 0.4 + 0.2), 1e-6);
}

/// Against the slow twin over a step within one field cell, away from its creases.
TEST(ScanLikelihood, FitsItsFieldWithTheSlopeThatDifferencesShow) {
  const Grid<float> room = mapped_cornered_room(0.05);
  ScanLikelihood likelihood(ScanLikelihoodConfig{}, 0.05);
  likelihood.look_at(room);
  const std::vector<Beam> probes = likelihood.probes_of(clean_sweep(cornered_room(), kTruePose, 720));
  const auto value = [&](const Pose2& pose) { return likelihood.field_log_likelihood(probes, pose); };
  for (std::uint32_t round = 0; round < 50; ++round) {
    Rng rng({.seed = 72, .purpose = Purpose::kWorld, .entity = round});
    const Pose2 pose =
        kTruePose * Pose2::exp({rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), rng.uniform(-0.05, 0.05)});
    const PoseFit fit = likelihood.field_fit(probes, pose);
    EXPECT_NEAR(fit.value, value(pose), 1e-6);
    const PoseFit slow = fit_by_differences(value, pose, 1e-5);
    EXPECT_NEAR((fit.gradient - slow.gradient).norm(), 0.0, 0.05 * slow.gradient.norm() + 1.0) << "round " << round;
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(fit.information).eigenvalues().minCoeff(), -1e-9);
  }
}

TEST(ScanLikelihood, WeighsLevelsAsTheLogOddsTheyStandFor) {
  Grid<float> room = mapped_cornered_room(0.05);
  Grid<std::int8_t> levels(room.frame());
  for (std::size_t i = 0; i < room.values().size(); ++i) {
    levels.values()[i] = level_of(room.values()[i], 0.4);
    room.values()[i] = log_odds_of(levels.values()[i], 0.4);
  }
  ScanLikelihood floats(ScanLikelihoodConfig{}, 0.05), integers(ScanLikelihoodConfig{}, 0.05);
  floats.look_at(room);
  integers.look_at(levels, 0.4);
  const std::vector<Beam> probes = floats.probes_of(clean_sweep(cornered_room(), kTruePose, 360));
  for (const Pose2& pose : {kTruePose, Pose2{0.0, -1.0, 2.0}, Pose2{-0.3, -0.7, 0.6}}) {
    EXPECT_EQ(floats.log_likelihood(probes, pose), integers.log_likelihood(probes, pose));
    EXPECT_EQ(floats.field_fit(probes, pose).gradient, integers.field_fit(probes, pose).gradient);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ScanLikelihoodOf, testing::Values(ScanModel::kLikelihoodField, ScanModel::kBeam),
                         [](const auto& given) {
                           return given.param == ScanModel::kBeam ? "Beam" : "LikelihoodField";
                         });

TEST(ScanLikelihood, LetsTheBeamModelMissByWhatTheRangeIsOff) {
  const Grid<float> map = drawn_grid({".....#", ".....#", ".....#"}, 1.0);
  const ScanLikelihoodConfig config{
      .model = ScanModel::kBeam, .effective_beams = 1.0, .hit_share = 0.8, .range_sigma = 0.1};
  ScanLikelihood likelihood(config, 1.0);
  likelihood.look_at(map);
  for (const auto& [range, off] : {std::pair{4.5, 0.0}, {5.4, 0.0}, {4.35, 0.15}, {5.7, 0.2}}) {
    const std::vector<Beam> probe{
        {.origin = {0.0, 0.0}, .end = {range, 0.0}, .range = static_cast<float>(range), .hit = true}};
    const double expected = std::log(0.8 * std::exp(-0.5 * off * off / 0.01) + 0.2);
    EXPECT_NEAR(likelihood.log_likelihood(probe, {0.5, 1.5, 0.0}), expected, 1e-5) << range;
  }
}

TEST(ScanLikelihood, LooksAtReturnsSpreadEvenlyOverTheSweep) {
  std::vector<Beam> sweep(1000);
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    sweep[i].range = static_cast<float>(i);
    sweep[i].hit = i % 4 != 0;
  }
  const std::vector<Beam> probes = ScanLikelihood({.beams = 75}, 0.1).probes_of(sweep);
  ASSERT_EQ(probes.size(), 75U);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    EXPECT_TRUE(probes[i].hit);
    EXPECT_NEAR(probes[i].range, 1000.0 / 75.0 * (static_cast<double>(i) + 0.5), 2.0);
  }
  EXPECT_EQ(ScanLikelihood({.beams = 2000}, 0.1).probes_of(sweep).size(), 750U);
  EXPECT_TRUE(ScanLikelihood({.beams = 10}, 0.1).probes_of({}).empty());
}

}  // namespace
}  // namespace cogslam
