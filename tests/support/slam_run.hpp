#pragma once

#include <string>
#include <utility>
#include <vector>

#include "slam/fast_slam.hpp"
#include "tests/support/synthetic_log.hpp"

// Filters on a synthetic log.

namespace cogslam {

/// A filter for the room of the log, started at its first true pose.
inline SlamConfig config_for(const SyntheticLog& log, int particles = 12) {
  SlamConfig config;
  config.particles = particles;
  config.cell_size = 0.1;
  config.area = Rectangle{{-3.5, -2.5}, {3.5, 2.5}};
  config.start = log.truth.front();
  config.likelihood.beams = 60;
  config.loops.waiting_scans = 3;  // these logs are short: with the usual twenty the maps would stay empty
  return config;
}

struct Outcome {
  std::vector<Pose2> online;
  std::vector<RegisteredPose> path;
  std::vector<bool> registered;
  FilterStatistics statistics;
  std::uint64_t hash = 0;
  Grid<float> map;
};

inline Outcome run(const SlamConfig& config, const SyntheticLog& log, std::uint32_t seed = 1, int threads = 2) {
  Workers workers(threads);
  FastSlam filter(config, seed, workers);
  Outcome outcome;
  for (const Reading& reading : log.readings) {
    outcome.registered.push_back(filter.update(reading));
    outcome.online.push_back(filter.T_map_base());
  }
  outcome.path = filter.best_path();
  outcome.statistics = filter.statistics();
  outcome.hash = filter.state_hash();
  outcome.map = filter.best_map();
  return outcome;
}

/// Every way to run the filter that changes which code is used.
inline std::vector<std::pair<std::string, SlamConfig>> variants_for(const SyntheticLog& log) {
  std::vector<std::pair<std::string, SlamConfig>> variants;
  const auto add = [&](const std::string& name, auto&& change) {
    SlamConfig config = config_for(log);
    change(config);
    variants.emplace_back(name, config);
  };
  add("as shipped", [](SlamConfig&) {});
  add("motion proposal", [](SlamConfig& c) { c.proposal = Proposal::kMotion; });
  add("beam model", [](SlamConfig& c) {
    c.proposal = Proposal::kMotion;
    c.likelihood.model = ScanModel::kBeam;
  });
  add("coefficients", [](SlamConfig& c) { c.store.kind = StoreKind::kCoefficients; });
  add("tiles", [](SlamConfig& c) { c.store.kind = StoreKind::kTiles; });
  add("tiles, dense at once", [](SlamConfig& c) { c.store = {.kind = StoreKind::kTiles, .seal_after = 0}; });
  add("two resolutions", [](SlamConfig& c) { c.store.kind = StoreKind::kTwoResolution; });
  add("lattice", [](SlamConfig& c) { c.store.kind = StoreKind::kLattice; });
  add("unclamped", [](SlamConfig& c) { c.log_odds.clamped = false; });
  add("last beam", [](SlamConfig& c) { c.log_odds.rule = CellRule::kLastBeam; });
  add("no area", [](SlamConfig& c) { c.area.reset(); });
  add("every step", [](SlamConfig& c) { c.resampling.every_step = true; });
  add("no compass", [](SlamConfig& c) { c.compass.used = false; });
  return variants;
}

}  // namespace cogslam
