#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "core/output_file.hpp"
#include "core/text_file.hpp"
#include "eval/sweep/command.hpp"
#include "eval/sweep/engine.hpp"
#include "eval/sweep/episode_job.hpp"
#include "eval/sweep/worker.hpp"

namespace cogslam {
namespace {

using std::chrono::milliseconds;
using Episodes = std::vector<const PlannedEpisode*>;

constexpr milliseconds kTick{100};
constexpr std::size_t kMaxErrorBytes = 100'000;

/// The id of a job array that may still be in the queue.
std::filesystem::path job_file(const SweepFolder& folder) { return folder.root / "slurm" / "job"; }

/// Writes a folder of its own for the lists and the script of one array, and gives it.
std::filesystem::path write_array(const std::string& name, const SweepFolder& folder, const Episodes& episodes,
                                  const SlurmConfig& config) {
  const std::filesystem::path lists = next_slurm_lists(folder);
  std::filesystem::create_directories(lists);
  const auto tasks = slurm_tasks(episodes, config.chunk);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    std::string jobs;
    for (const PlannedEpisode* episode : tasks[i]) jobs += EpisodeJob::of(*episode).line() + "\n";
    write_file(lists / (std::to_string(i) + ".jobs"), jobs);
  }
  for (const PlannedEpisode* episode : episodes) {
    write_file(folder.episode(episode->key, ".yaml"), episode->scenario);
    std::filesystem::remove(folder.episode(episode->key, ".error"));
  }
  write_file(lists / "array.sh", slurm_script(name, tasks.size(), lists, folder, config));
  return lists;
}

/// A job array, from its submission to its end.
class SlurmArray {
 public:
  static SlurmArray submit(const SweepFolder& folder, const std::filesystem::path& lists) {
    const CommandOutcome outcome = run_command({"sbatch", "--parsable", (lists / "array.sh").string()});
    const std::string id = outcome.out.substr(0, outcome.out.find_first_of(";\n"));
    if (outcome.code == 127) throw std::runtime_error("sbatch cannot be started: is Slurm installed here?");
    if (outcome.code != 0 || id.empty()) throw std::runtime_error("sbatch refused " + (lists / "array.sh").string());
    write_file(job_file(folder), id + "\n");
    return SlurmArray(id);
  }
  /// One that an earlier sweep has left in the queue; nothing where there is none.
  static std::optional<SlurmArray> left_behind(const SweepFolder& folder) {
    std::ifstream in(job_file(folder));
    std::string id;
    if (!(in >> id)) return std::nullopt;
    SlurmArray array(id);
    return array.ended() ? std::nullopt : std::optional(array);
  }

  /// Whether no task is waiting or running. A controller that does not answer is asked again later, but not for ever.
  bool ended() {
    const CommandOutcome outcome = run_command({"squeue", "--noheader", "--format=%F"});
    if (outcome.code != 0) {
      if (++silent_ > kMostSilent) throw std::runtime_error("squeue fails again and again; job " + id_ + " goes on");
      return false;
    }
    silent_ = 0;
    std::istringstream in(outcome.out);
    for (std::string id; in >> id;) {
      if (id == id_) return false;
    }
    return true;
  }
  void cancel() { run_command({"scancel", id_}); }
  [[nodiscard]] const std::string& id() const { return id_; }

 private:
  static constexpr int kMostSilent = 100;

  explicit SlurmArray(std::string id) : id_(std::move(id)) {}

  std::string id_;
  int silent_ = 0;
};

class SlurmEngine {
 public:
  SlurmEngine(const SweepFolder& folder, const Episodes& episodes, const SlurmConfig& config, const EpisodeEnd& end,
              const std::function<void()>& tick)
      : folder_(folder), open_(episodes), config_(config), end_(end), tick_(tick) {}

  void run(const std::string& name) {
    if (auto array = SlurmArray::left_behind(folder_)) await(*array);
    gather();
    for (int round = 0; round < config_.rounds && !open_.empty(); ++round) {
      SlurmArray array = SlurmArray::submit(folder_, write_array(name, folder_, open_, config_));
      await(array);
    }
    for (const PlannedEpisode* episode : open_) {
      end_(*episode, fmt::format("no result of {} job arrays; their logs lie in slurm/", config_.rounds));
    }
  }

 private:
  void await(SlurmArray& array) {
    try {
      while (!array.ended()) {
        gather();
        pause();
      }
      gather();
      if (open_.empty()) return;
      pause();  // a file system shared over the network may show the last files late
      gather();
    } catch (const std::runtime_error&) {
      throw;  // the array may go on: the next sweep finds it
    } catch (...) {
      array.cancel();
      throw;
    }
  }

  /// Tells of the episodes that are over since the last time.
  void gather() {
    std::erase_if(open_, [&](const PlannedEpisode* episode) {
      if (std::filesystem::exists(folder_.episode(episode->key, ".json"))) {
        end_(*episode, "");
        return true;
      }
      const std::filesystem::path error = folder_.episode(episode->key, ".error");
      if (!std::filesystem::exists(error)) return false;
      end_(*episode, read_text_file(error, kMaxErrorBytes));
      return true;
    });
  }

  void pause() {
    for (milliseconds passed{0}; passed < milliseconds(config_.poll_ms); passed += kTick) {
      tick_();
      std::this_thread::sleep_for(kTick);
    }
  }

  const SweepFolder& folder_;
  Episodes open_;
  const SlurmConfig& config_;
  const EpisodeEnd& end_;
  const std::function<void()>& tick_;
};

}  // namespace

void run_on_slurm(const std::string& name, const SweepFolder& folder, const Episodes& episodes,
                  const SlurmConfig& config, const EpisodeEnd& end, const std::function<void()>& tick) {
  SlurmEngine(folder, episodes, config, end, tick).run(name);
}

}  // namespace cogslam
