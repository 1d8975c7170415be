#pragma once

#include <string>

#include "eval/sweep/database.hpp"
#include "eval/sweep/folder.hpp"
#include "eval/sweep/plan.hpp"
#include "eval/sweep/readings_cache.hpp"
#include "eval/variant_run.hpp"

namespace cogslam {

/// A sweep with its results: what figures are drawn from.
struct MeasuredSweep {
  SweepPlan plan;
  SweepFolder folder;
  EpisodeTable table;
};

/// Which episode of a sweep.
struct EpisodeName {
  std::string world;
  double cell_size = 0.0;  ///< [m]
  std::string variant;
  std::uint32_t seed = 0;
};

/// The episode of this name, which must be planned.
const PlannedEpisode& planned(const SweepPlan& plan, const EpisodeName& name);

/// The readings of an episode and their truth; simulated again where the sweep's folder holds them no more.
CachedReadings readings_of(const MeasuredSweep& sweep, const PlannedEpisode& episode);

/// The episode once more, for its path and map: those that the sweep scored, bit by bit. Of a baseline that the sweep's
/// folder still holds, only `online` and `map` are filled.
VariantRun run_again(const MeasuredSweep& sweep, const PlannedEpisode& episode, const CachedReadings& readings,
                     Workers& workers);

}  // namespace cogslam
