#include "slam/slam_config.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "core/number_text.hpp"
#include "slam/map/reach.hpp"

namespace cogslam {
namespace {

void read_store(ConfigSection section, StoreConfig& store) {
  section.read_choice("kind", store.kind,
                      {{"dense", StoreKind::kDense},
                       {"coefficients", StoreKind::kCoefficients},
                       {"tiles", StoreKind::kTiles},
                       {"two_resolution", StoreKind::kTwoResolution},
                       {"lattice", StoreKind::kLattice}});
  section.read("seal_after_scans", store.seal_after, {0, 30000});
  section.read("lattice_unit", store.lattice_unit, {1e-3, 10.0});
  section.read("percent_kept", store.percent_kept, {1e-6, 100.0});
  read_compression(section, store.compression);
}

void read_log_odds(ConfigSection section, LogOddsModel& model) {
  double hit = model.hit, free = model.free, min = model.min, max = model.max;
  section.read("hit", hit, {1e-3, 20.0});
  section.read("free", free, {-20.0, -1e-3});
  section.read("clamped", model.clamped);
  section.read("min", min, {-1000.0, 0.0});
  section.read("max", max, {0.0, 1000.0});
  section.read_choice("rule", model.rule,
                      {{"hit_beats_miss", CellRule::kHitBeatsMiss}, {"last_beam", CellRule::kLastBeam}});
  model.hit = static_cast<float>(hit);
  model.free = static_cast<float>(free);
  model.min = static_cast<float>(min);
  model.max = static_cast<float>(max);
}

void read_likelihood(ConfigSection section, ScanLikelihoodConfig& likelihood) {
  section.read_choice("model", likelihood.model,
                      {{"likelihood_field", ScanModel::kLikelihoodField}, {"beam", ScanModel::kBeam}});
  section.read("beams", likelihood.beams, {1, 100000});
  section.read("effective_beams", likelihood.effective_beams, {0.01, 1e6});
  section.read("hit_share", likelihood.hit_share, {0.01, 0.9999});
  section.read("unknown_value", likelihood.unknown_value, {0.0, 1.0});
  section.read("range_sigma_m", likelihood.range_sigma, {1e-4, 10.0});
  section.read("field_sigma_m", likelihood.field.sigma, {1e-3, 10.0});
  section.read("field_sample_m", likelihood.field.finest_sample, {1e-3, 10.0});
}

void read_compass(ConfigSection section, CompassModel& compass) {
  section.read("used", compass.used);
  section.read_degrees("noise_deg", compass.noise, {1e-3, 180.0});
  section.read_degrees("bias_sigma_deg", compass.bias_sigma, {0.0, 180.0});
}

void read_motion(ConfigSection section, MotionModelConfig& motion) {
  section.read("inflation", motion.inflation, {0.0, 1000.0});
  section.read("least_sigma_m", motion.least_sigma_position, {1e-6, 10.0});
  section.read_degrees("least_sigma_deg", motion.least_sigma_heading, {1e-5, 180.0});
}

void read_sweep(ConfigSection section, SweepConfig& sweep) {
  section.read("beams", sweep.beams, {1, 1e6});
  section.read("max_hit_range_m", sweep.max_hit_range, {0.01, 300.0});
  section.read("max_free_range_m", sweep.max_free_range, {0.01, 300.0});
  section.read("carve_no_return", sweep.carve_no_return);
}

void read_matcher(ConfigSection section, ScanMatcherConfig& matcher) {
  section.read("sharpness", matcher.sharpness, {1e-3, 1e3});
  section.read("window_sigmas", matcher.window_sigmas, {0.0, 100.0});
  section.read("coarse_step_m", matcher.coarse_step, {1e-4, 10.0});
  section.read("coarse_steps_max", matcher.coarse_steps_max, {0, 100});
}

void read_tracker(ConfigSection section, TrackerConfig& tracker) {
  section.read("used", tracker.used);
  section.read("beams", tracker.beams, {1, 100000});
  section.read("gap_m", tracker.gap, {1e-3, 100.0});
  section.read("keys", tracker.keys, {1, 1000});
  section.read("cell_m", tracker.cell, {1e-3, 10.0});
  section.read_degrees("turn_step_deg", tracker.turn_step, {1e-3, 180.0});
  section.read("inflation", tracker.inflation, {1e-3, 1e3});
  section.read("least_sigma_m", tracker.least_sigma_position, {1e-6, 10.0});
  section.read_degrees("least_sigma_deg", tracker.least_sigma_heading, {1e-5, 180.0});
  section.read("spread", tracker.spread, {1e-3, 1e3});
  section.read("spread_m", tracker.spread_position, {1e-6, 10.0});
  section.read_degrees("spread_deg", tracker.spread_heading, {1e-5, 180.0});
  section.read("first_reach_m", tracker.match.first_reach, {0.05, 10.0});
  section.read("last_reach_m", tracker.match.last_reach, {1e-3, 10.0});
  section.read("sigma_m", tracker.match.sigma, {1e-4, 10.0});
  section.read("point_share", tracker.match.point_share, {1e-6, 1.0});
}

void read_loops(ConfigSection section, LoopConfig& loops) {
  section.read("waiting_scans", loops.waiting_scans, {0, 1000});
  section.read("drift_m", loops.drift_position, {0.0, 10.0});
  section.read_degrees("drift_deg", loops.drift_heading, {0.0, 180.0});
  section.read("known_share", loops.known_share, {0.0, 1.0});
  section.read("sight_m", loops.sight, kPositive);
  section.read("least_way_m", loops.least_way, kPositive);
}

/// The place of a value that is off the lattice, where the file states it here; SlamConfig::check finds the others.
void check_lattice(ConfigSection& section, const SlamConfig& config) {
  if (!keeps_levels(config.store.kind) || !section.has("log_odds")) return;
  const auto trouble = lattice_trouble(config.log_odds, config.store.lattice_unit);
  ConfigSection log_odds = section.section("log_odds");
  if (trouble && log_odds.has(trouble->key)) log_odds.fail(trouble->key, trouble->key + ": " + trouble->message);
}

constexpr double kLongestSide = 32768.0;  // cells: what the transforms take
constexpr double kFinestShare = 100.0;

void check_size(const Rectangle& area, double cell_size) {
  const Eigen::Vector2d cells = (area.max - area.min) / cell_size;
  const double farthest = std::max(area.min.cwiseAbs().maxCoeff(), area.max.cwiseAbs().maxCoeff()) / cell_size;
  if (cells.maxCoeff() > kLongestSide || cells.prod() > kMostMapCells || farthest > kFarthestCell) {
    throw InputError("map area of " + number_text(std::ceil(cells.x())) + " x " + number_text(std::ceil(cells.y())) +
                     " cells, expected at most 32768 along a side, 268435456 in all, and no corner beyond 10^9 cells");
  }
}

}  // namespace

std::optional<GridFrame> SlamConfig::map_frame() const {
  if (!area) return std::nullopt;
  return GridFrame::covering(*area, cell_size);
}

void SlamConfig::check() const {
  EXPECTS(particles > 0 && cell_size > 0.0);
  if (store.kind == StoreKind::kCoefficients && !area) {
    throw InputError(
        "store 'coefficients' transforms the whole map: it needs a stated map area (map.area_m, or --area)");
  }
  if (area) check_size(*area, cell_size);
  if (cell_size / likelihood.field.finest_sample > kFinestShare) {
    throw InputError("likelihood: field_sample_m must be at least a hundredth of the cell size of " +
                     number_text(cell_size) + " m");
  }
  if (store.kind == StoreKind::kCoefficients && !store.compression.is_papers_choice()) {
    const GridFrame frame = *map_frame();
    if (const auto trouble = trouble_of(store.compression, store.percent_kept, frame.width, frame.height)) {
      throw InputError("store: " + trouble->key + ": " + trouble->message);
    }
  }
  if (keeps_levels(store.kind)) {
    if (const auto trouble = lattice_trouble(log_odds, store.lattice_unit)) {
      throw InputError("log_odds: " + trouble->key + ": " + trouble->message);
    }
  }
  // The field looks at 63 cells of a row at once, and reaches 3 sigma.
  if (likelihood.field.sigma > 21.0 * cell_size) {
    throw InputError("likelihood: field_sigma_m must be at most 21 cells of " + number_text(cell_size) + " m");
  }
  tracker.check();
  if (log_odds.clamped && (log_odds.min >= 0.0F || log_odds.max <= 0.0F)) {
    throw InputError("log_odds: min must be below 0 and max above 0");
  }
  if (proposal == Proposal::kScanMatched && likelihood.model == ScanModel::kBeam) {
    throw InputError("likelihood model 'beam' weighs poses drawn from the motion: it needs proposal 'motion'");
  }
  if (log_odds.clamped && log_odds.max <= kOccupiedLogOdds) {
    throw InputError("log_odds: max must be above " + number_text(kOccupiedLogOdds) +
                     ", or no cell ever counts as an obstacle");
  }
}

void read_slam_config(ConfigSection& section, SlamConfig& config) {
  section.read("particles", config.particles, {1, 1000000});
  section.read_choice("proposal", config.proposal,
                      {{"motion", Proposal::kMotion}, {"scan_matched", Proposal::kScanMatched}});
  read_store(section.section("store"), config.store);
  read_log_odds(section.section("log_odds"), config.log_odds);
  check_lattice(section, config);
  read_sweep(section.section("sweep"), config.sweep);
  read_tracker(section.section("tracker"), config.tracker);
  read_motion(section.section("motion"), config.motion);
  ConfigSection registration = section.section("registration");
  registration.read("distance_m", config.registration.distance, {1e-6, 1e6});
  registration.read_degrees("turn_deg", config.registration.turn, {1e-6, 1e6});
  read_loops(section.section("loops"), config.loops);
  read_likelihood(section.section("likelihood"), config.likelihood);
  read_matcher(section.section("matcher"), config.matcher);
  read_compass(section.section("compass"), config.compass);
  ConfigSection resampling = section.section("resampling");
  resampling.read("effective_share", config.resampling.effective_share, {1e-6, 1.0});
  resampling.read("every_step", config.resampling.every_step);
}

}  // namespace cogslam
