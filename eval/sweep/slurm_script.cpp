#include "eval/sweep/slurm_script.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMostTasks = 1000;  // Slurm's MaxArraySize is 1001 unless the cluster says otherwise

/// For the shell: a path may hold blanks.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string option(const char* name, const std::string& value) {
  if (value.empty()) return "";
  if (value.find_first_of(" \t\n#") != std::string::npos) {
    throw InputError(std::string("--") + name + ": expected one word, found '" + value + "'");
  }
  return std::string("#SBATCH --") + name + "=" + value + "\n";
}

}  // namespace

std::vector<std::vector<const PlannedEpisode*>> slurm_tasks(const std::vector<const PlannedEpisode*>& episodes,
                                                            std::size_t chunk) {
  const std::size_t most = std::max({chunk, (episodes.size() + kMostTasks - 1) / kMostTasks, std::size_t{1}});
  std::vector<std::vector<const PlannedEpisode*>> tasks;
  for (std::size_t begin = 0; begin < episodes.size();) {
    std::size_t end = begin + 1;
    while (end < episodes.size() && episodes[end]->readings_key == episodes[begin]->readings_key) ++end;
    const bool fits = !tasks.empty() && tasks.back().size() + (end - begin) <= most;
    if (!fits) tasks.emplace_back();
    for (; begin < end; ++begin) {
      if (tasks.back().size() == most) tasks.emplace_back();
      tasks.back().push_back(episodes[begin]);
    }
  }
  return tasks;
}

std::filesystem::path next_slurm_lists(const SweepFolder& folder) {
  const std::filesystem::path parent = folder.root / "slurm";
  int number = 1;
  while (std::filesystem::exists(parent / std::to_string(number))) ++number;
  return parent / std::to_string(number);
}

std::string slurm_script(const std::string& name, std::size_t tasks, const std::filesystem::path& lists,
                         const SweepFolder& folder, const SlurmConfig& config) {
  return "#!/bin/sh\n#SBATCH --job-name=cogslam_" + name + "\n#SBATCH --array=0-" + std::to_string(tasks - 1) +
         "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --output=" + (lists / "%a.log").string() + "\n" +
         option("partition", config.partition) + option("time", config.time) + option("account", config.account) +
         "export OMP_NUM_THREADS=1 OPENCV_FOR_THREADS_NUM=1 LP_NUM_THREADS=0\n"
         "exec " +
         quoted(config.program.string()) + " sweep-worker " + quoted(folder.root.string()) + " --list " +
         quoted((lists / "").string()) + "\"$SLURM_ARRAY_TASK_ID\".jobs\n";
}

}  // namespace cogslam
