#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "eval/sweep/episode_job.hpp"
#include "eval/sweep/plan.hpp"

namespace cogslam {

/// Which job comes next: the earliest whose readings and baseline are there. So nothing is computed twice, and no
/// worker is idle while there is something to do.
class JobQueue {
 public:
  /// `episodes` must outlive the queue.
  JobQueue(const SweepFolder& folder, const std::vector<const PlannedEpisode*>& episodes);

  struct Next {
    std::size_t episode;  ///< index into the episodes
    EpisodeJob job;
  };
  /// Takes a job that can be done now; nothing where all that is left waits for jobs that were taken.
  std::optional<Next> take();
  /// A job that was taken is over, well or badly.
  void finish(const Next& job);
  /// Whether every job was taken.
  [[nodiscard]] bool empty() const { return left_.empty(); }

 private:
  [[nodiscard]] bool waits_for_baseline(const PlannedEpisode& episode) const;

  SweepFolder folder_;
  std::vector<const PlannedEpisode*> episodes_;
  std::vector<std::size_t> left_;         ///< not yet taken, in order
  std::set<std::string> readings_made_;   ///< or tried in vain
  std::set<std::string> readings_taken_;  ///< being made
  std::set<std::string> to_come_;         ///< own keys of episodes that are not over
};

}  // namespace cogslam
