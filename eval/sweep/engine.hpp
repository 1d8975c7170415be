#pragma once

#include <functional>
#include <string>
#include <vector>

#include "eval/sweep/folder.hpp"
#include "eval/sweep/plan.hpp"
#include "eval/sweep/slurm_script.hpp"

namespace cogslam {

/// Told of each episode that is over, in the order in which they end: `error` is empty where its result lies in
/// `episodes/<key>.json`.
using EpisodeEnd = std::function<void(const PlannedEpisode& episode, const std::string& error)>;

struct LocalEngineConfig {
  std::filesystem::path program;  ///< this one: its command `sweep-worker` does the work
  int workers = 1;
  bool fail_fast = false;  ///< the first failure is the last
};

/// Runs the episodes in worker processes of this machine (a rasteriser takes one thread per process), the earlier
/// first. `tick` is called a few times a second; throw from it to stop: nothing that was told of is lost. Throws
/// std::runtime_error where going on is of no use, as on a full disk.
void run_locally(const SweepFolder& folder, const std::vector<const PlannedEpisode*>& episodes,
                 const LocalEngineConfig& config, const EpisodeEnd& end, const std::function<void()>& tick);

/// The same by job arrays of Slurm, whose tasks write results that are gathered from `episodes/`: only this process
/// opens the database. What is missing when an array is over is submitted again, `rounds` times. An array
/// that an earlier, killed sweep left in the queue is waited for. Where `tick` throws the array is cancelled. `folder`
/// must be an absolute path that every node sees.
void run_on_slurm(const std::string& name, const SweepFolder& folder,
                  const std::vector<const PlannedEpisode*>& episodes, const SlurmConfig& config, const EpisodeEnd& end,
                  const std::function<void()>& tick);

}  // namespace cogslam
