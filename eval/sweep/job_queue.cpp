#include "eval/sweep/job_queue.hpp"

namespace cogslam {

JobQueue::JobQueue(const SweepFolder& folder, const std::vector<const PlannedEpisode*>& episodes)
    : folder_(folder), episodes_(episodes) {
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    left_.push_back(i);
    to_come_.insert(episodes[i]->own_key);
  }
}

bool JobQueue::waits_for_baseline(const PlannedEpisode& episode) const {
  // One that is not to come (measured long ago, and its file lost) is made by whoever needs it.
  return !episode.baseline_key.empty() && to_come_.contains(episode.baseline_key);
}

std::optional<JobQueue::Next> JobQueue::take() {
  for (auto at = left_.begin(); at != left_.end(); ++at) {
    const PlannedEpisode& episode = *episodes_[*at];
    const std::string& readings = episode.readings_key;
    if (!readings_made_.contains(readings)) {
      if (readings_taken_.contains(readings)) continue;
      if (!has_readings(folder_, readings)) {
        readings_taken_.insert(readings);
        return Next{*at, EpisodeJob::of(episode, true)};
      }
      readings_made_.insert(readings);
    }
    if (waits_for_baseline(episode)) continue;
    const std::size_t index = *at;
    left_.erase(at);
    return Next{index, EpisodeJob::of(episode)};
  }
  return std::nullopt;
}

void JobQueue::finish(const Next& next) {
  if (next.job.only_readings) {
    readings_taken_.erase(next.job.readings_key);
    readings_made_.insert(next.job.readings_key);
  } else {
    to_come_.erase(next.job.own_key);
  }
}

}  // namespace cogslam
