#include "slam/slam_config.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

constexpr const char* kEverything = R"(particles: 37
proposal: motion
store: {kind: coefficients, percent_kept: 12.5}
log_odds: {hit: 0.7, free: -0.3, clamped: false, min: -4, max: 5, rule: last_beam}
sweep: {max_hit_range_m: 20, max_free_range_m: 9, carve_no_return: true}
motion: {inflation: 2.25, least_sigma_m: 0.004, least_sigma_deg: 0.25}
registration: {distance_m: 0.3, turn_deg: 10}
likelihood: {model: beam, beams: 55, effective_beams: 7, hit_share: 0.8, unknown_value: 0.2, range_sigma_m: 0.07, field_sigma_m: 0.06,
             field_sample_m: 0.025}
tracker: {used: false, beams: 99, gap_m: 0.3, keys: 7, cell_m: 0.06, turn_step_deg: 4, inflation: 2.5, least_sigma_m: 0.04,
          least_sigma_deg: 0.3, first_reach_m: 0.7, last_reach_m: 0.2, sigma_m: 0.03, point_share: 0.4}
matcher: {window_sigmas: 3, coarse_step_m: 0.04, coarse_steps_max: 5}
compass: {used: false, noise_deg: 4, bias_sigma_deg: 5}
resampling: {effective_share: 0.7, every_step: true}
)";

/// Reads a text; the section is returned for its resolved form.
std::pair<SlamConfig, std::string> read_text(const std::string& text) {
  ConfigSection section = ConfigSection::parse(text, "slam.yaml");
  SlamConfig config;
  read_slam_config(section, config);
  section.finish();
  return {config, section.resolved()};
}

std::string reading_error(const std::string& text) {
  return error_text([&] { read_text(text); });
}

TEST(SlamConfig, ReadsEveryKey) {
  const SlamConfig config = read_text(kEverything).first;
  constexpr double kDegree = std::numbers::pi / 180.0;
  EXPECT_EQ(config.particles, 37);
  EXPECT_EQ(config.proposal, Proposal::kMotion);
  EXPECT_EQ(config.store.kind, StoreKind::kCoefficients);
  EXPECT_EQ(config.store.percent_kept, 12.5);
  EXPECT_FLOAT_EQ(config.log_odds.hit, 0.7F);
  EXPECT_FLOAT_EQ(config.log_odds.free, -0.3F);
  EXPECT_FALSE(config.log_odds.clamped);
  EXPECT_EQ(config.log_odds.min, -4.0F);
  EXPECT_EQ(config.log_odds.max, 5.0F);
  EXPECT_EQ(config.log_odds.rule, CellRule::kLastBeam);
  EXPECT_EQ(config.sweep.max_hit_range, 20.0);
  EXPECT_EQ(config.sweep.max_free_range, 9.0);
  EXPECT_TRUE(config.sweep.carve_no_return);
  EXPECT_EQ(config.motion.inflation, 2.25);
  EXPECT_EQ(config.motion.least_sigma_position, 0.004);
  EXPECT_NEAR(config.motion.least_sigma_heading, 0.25 * kDegree, 1e-15);
  EXPECT_EQ(config.registration.distance, 0.3);
  EXPECT_NEAR(config.registration.turn, 10.0 * kDegree, 1e-15);
  EXPECT_EQ(config.likelihood.model, ScanModel::kBeam);
  EXPECT_EQ(config.likelihood.beams, 55);
  EXPECT_EQ(config.likelihood.effective_beams, 7.0);
  EXPECT_EQ(config.likelihood.hit_share, 0.8);
  EXPECT_EQ(config.likelihood.unknown_value, 0.2);
  EXPECT_EQ(config.likelihood.range_sigma, 0.07);
  EXPECT_EQ(config.likelihood.field.sigma, 0.06);
  EXPECT_EQ(config.likelihood.field.finest_sample, 0.025);
  EXPECT_FALSE(config.tracker.used);
  EXPECT_EQ(config.tracker.beams, 99);
  EXPECT_EQ(config.tracker.gap, 0.3);
  EXPECT_EQ(config.tracker.keys, 7);
  EXPECT_EQ(config.tracker.cell, 0.06);
  EXPECT_NEAR(config.tracker.turn_step, 4.0 * kDegree, 1e-15);
  EXPECT_EQ(config.tracker.inflation, 2.5);
  EXPECT_EQ(config.tracker.least_sigma_position, 0.04);
  EXPECT_NEAR(config.tracker.least_sigma_heading, 0.3 * kDegree, 1e-15);
  EXPECT_EQ(config.tracker.match.first_reach, 0.7);
  EXPECT_EQ(config.tracker.match.last_reach, 0.2);
  EXPECT_EQ(config.tracker.match.sigma, 0.03);
  EXPECT_EQ(config.tracker.match.point_share, 0.4);
  EXPECT_EQ(config.matcher.window_sigmas, 3.0);
  EXPECT_EQ(config.matcher.coarse_step, 0.04);
  EXPECT_EQ(config.matcher.coarse_steps_max, 5);
  EXPECT_FALSE(config.compass.used);
  EXPECT_NEAR(config.compass.noise, 4.0 * kDegree, 1e-15);
  EXPECT_NEAR(config.compass.bias_sigma, 5.0 * kDegree, 1e-15);
  EXPECT_EQ(config.resampling.effective_share, 0.7);
  EXPECT_TRUE(config.resampling.every_step);
}

TEST(SlamConfig, ResolvesToATextThatReadsAsItself) {
  for (const std::string text : {"{}", kEverything}) {
    const std::string resolved = read_text(text).second;
    EXPECT_EQ(read_text(resolved).second, resolved);
  }
  EXPECT_NE(read_text("{}").second, read_text(kEverything).second);
}

TEST(SlamConfig, KeepsItsDefaultsWhereNothingIsSaid) {
  const SlamConfig config = read_text("{}").first, defaults;
  EXPECT_EQ(config.particles, defaults.particles);
  EXPECT_EQ(config.log_odds.hit, defaults.log_odds.hit);
  EXPECT_NEAR(config.compass.noise, defaults.compass.noise, 1e-15);
  EXPECT_NEAR(config.registration.turn, defaults.registration.turn, 1e-15);
  EXPECT_NO_THROW(config.check());
}

TEST(SlamConfig, SaysWhereAKeyIsWrong) {
  EXPECT_THAT(reading_error("particles: 0\n"), testing::StartsWith("slam.yaml:1:12: "));
  EXPECT_THAT(reading_error("particle: 10\n"),
              testing::AllOf(testing::StartsWith("slam.yaml:1:1: "), testing::HasSubstr("particles")));
  EXPECT_THAT(reading_error("store: {kind: dens}\n"), testing::HasSubstr("dense"));
  EXPECT_THAT(reading_error("store: {percent_kept: 101}\n"), testing::StartsWith("slam.yaml:1:23: "));
  EXPECT_THAT(reading_error("log_odds: {free: 0.4}\n"), testing::StartsWith("slam.yaml:1:18: "));
}

TEST(SlamConfig, RefusesPartsThatContradictEachOther) {
  SlamConfig config;
  config.store.kind = StoreKind::kCoefficients;
  EXPECT_EQ(error_text([&] { config.check(); }),
            "store 'coefficients' transforms the whole map: it needs a stated map area (map.area_m, or --area)");
  config.area = Rectangle{{0.0, 0.0}, {3.0, 2.0}};
  EXPECT_EQ(error_text([&] { config.check(); }), "no error");
  config.log_odds.min = 0.0F;
  EXPECT_EQ(error_text([&] { config.check(); }), "log_odds: min must be below 0 and max above 0");
  config.log_odds.min = -2.0F;
  config.log_odds.max = 0.5F;
  EXPECT_EQ(error_text([&] { config.check(); }),
            "log_odds: max must be above 0.5, or no cell ever counts as an obstacle");
  config.log_odds.clamped = false;  // then the limits say nothing
  EXPECT_EQ(error_text([&] { config.check(); }), "no error");
}

TEST(SlamConfig, RefusesAFieldThatReachesTooManyCells) {
  SlamConfig config;
  config.cell_size = 0.02;
  config.likelihood.field.sigma = 0.42;
  EXPECT_EQ(error_text([&] { config.check(); }), "no error");
  config.likelihood.field.sigma = 0.43;
  EXPECT_EQ(error_text([&] { config.check(); }), "likelihood: field_sigma_m must be at most 21 cells of 0.02 m");
}

TEST(SlamConfig, RefusesATrackerThatNarrowsItsReachTheWrongWay) {
  SlamConfig config;
  config.tracker.match.last_reach = config.tracker.match.first_reach * 1.01;
  EXPECT_EQ(error_text([&] { config.check(); }), "tracker: last_reach_m must not exceed first_reach_m");
}

TEST(SlamConfig, CoversItsAreaWithLatticeCells) {
  SlamConfig config;
  EXPECT_FALSE(config.map_frame().has_value());
  config.cell_size = 0.5;
  config.area = Rectangle{{-0.2, 0.0}, {2.0, 1.1}};
  EXPECT_EQ(config.map_frame(), (GridFrame{.cell_size = 0.5, .lattice_min = {-1, 0}, .width = 5, .height = 3}));
}

}  // namespace
}  // namespace cogslam
