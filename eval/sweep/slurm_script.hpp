#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/sweep/folder.hpp"
#include "eval/sweep/plan.hpp"

namespace cogslam {

/// How work is handed to Slurm.
struct SlurmConfig {
  std::filesystem::path program;  ///< this one, under a name that every node knows
  std::string partition;          ///< empty: the cluster's usual one
  std::string time;               ///< limit of a task, in Slurm's words; empty: the cluster's usual one
  std::string account;            ///< empty: the user's usual one
  std::size_t chunk = 60;         ///< episodes per task of the array, at most
  int rounds = 5;                 ///< submit what is missing at most so often
  int poll_ms = 2000;             ///< between two looks at the queue
};

/// Splits the episodes, in their order, into the tasks of a job array: at most `chunk` in each (more where that would
/// take over 1000 tasks), and those with the same readings together as long as they fit.
std::vector<std::vector<const PlannedEpisode*>> slurm_tasks(const std::vector<const PlannedEpisode*>& episodes,
                                                            std::size_t chunk);

/// The folder of the next array's lists: `slurm/<number>`, not yet there.
std::filesystem::path next_slurm_lists(const SweepFolder& folder);

/// The batch script of an array of `tasks` tasks; task i does the jobs in `<lists>/<i>.jobs`.
std::string slurm_script(const std::string& name, std::size_t tasks, const std::filesystem::path& lists,
                         const SweepFolder& folder, const SlurmConfig& config);

}  // namespace cogslam
