#include "eval/figures/measured_sweep.hpp"

#include <algorithm>

#include "core/check.hpp"
#include "core/error.hpp"
#include "eval/sweep/baseline_file.hpp"

namespace cogslam {
namespace {

Scenario scenario_of(const PlannedEpisode& episode) {
  return read_scenario(ConfigSection::parse(episode.scenario, "episode " + episode.key), episode.world);
}

}  // namespace

const PlannedEpisode& planned(const SweepPlan& plan, const EpisodeName& name) {
  const auto found = std::find_if(plan.episodes.begin(), plan.episodes.end(), [&](const PlannedEpisode& e) {
    return e.world == name.world && e.cell_size == name.cell_size && e.variant == name.variant && e.seed == name.seed;
  });
  EXPECTS(found != plan.episodes.end());
  return *found;
}

CachedReadings readings_of(const MeasuredSweep& sweep, const PlannedEpisode& episode) {
  return cached_readings(sweep.folder, episode.readings_key, scenario_of(episode));
}

VariantRun run_again(const MeasuredSweep& sweep, const PlannedEpisode& episode, const CachedReadings& readings,
                     Workers& workers) {
  const std::filesystem::path kept = sweep.folder.baseline(episode.own_key);
  if (std::filesystem::exists(kept)) {
    try {
      return read_baseline(kept);
    } catch (const InputError&) {
      // damaged: run it
    }
  }
  const Scenario scenario = scenario_of(episode);
  return run_variant(scenario.variants.back(), scenario.seed, readings.recording, {.truth = &readings.truth}, workers);
}

}  // namespace cogslam
