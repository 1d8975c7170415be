#include <poll.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "core/output_file.hpp"
#include "eval/sweep/engine.hpp"
#include "eval/sweep/job_queue.hpp"
#include "eval/sweep/worker.hpp"
#include "eval/sweep/worker_process.hpp"

namespace cogslam {
namespace {

constexpr int kTickMs = 100;

struct Seat {
  std::unique_ptr<WorkerProcess> worker;
  std::optional<JobQueue::Next> job;
};

class LocalEngine {
 public:
  LocalEngine(const SweepFolder& folder, const std::vector<const PlannedEpisode*>& episodes,
              const LocalEngineConfig& config, const EpisodeEnd& end)
      : folder_(folder), episodes_(episodes), config_(config), end_(end), queue_(folder, episodes) {
    seats_.resize(std::min(static_cast<std::size_t>(config.workers), episodes.size()));
  }

  void run(const std::function<void()>& tick) {
    for (tick(); deal_out(); tick()) wait();
  }

 private:
  /// Gives every free seat a job; false where all is done.
  bool deal_out() {
    bool busy = false;
    for (Seat& seat : seats_) {
      if (!seat.job && !stopping_) {
        if ((seat.job = queue_.take())) begin(seat);
      }
      busy = busy || seat.job;
    }
    return busy;
  }

  void begin(Seat& seat) {
    const PlannedEpisode& episode = *episodes_[seat.job->episode];
    write_file(folder_.episode(episode.key, ".yaml"), episode.scenario);
    if (!seat.worker) {
      seat.worker = std::make_unique<WorkerProcess>(config_.program,
                                                    std::vector<std::string>{"sweep-worker", folder_.root.string()});
    }
    seat.worker->send(seat.job->job.line());  // where it is gone, `wait` notices
  }

  void wait() {
    std::vector<pollfd> ready;
    for (const Seat& seat : seats_) ready.push_back({seat.job ? seat.worker->descriptor() : -1, POLLIN, 0});
    if (poll(ready.data(), ready.size(), kTickMs) < 0 && errno != EINTR) {
      throw std::runtime_error(std::string("cannot wait for the workers: ") + std::strerror(errno));
    }
    for (std::size_t i = 0; i < seats_.size(); ++i) {
      if (ready[i].revents != 0) hear(seats_[i]);
    }
  }

  void hear(Seat& seat) {
    if (!seat.worker->receive()) {
      const std::string farewell = "failed the worker " + seat.worker->farewell();
      seat.worker.reset();
      return take_answer(seat, farewell);
    }
    if (const auto line = seat.worker->next_line()) take_answer(seat, *line);
  }

  void take_answer(Seat& seat, const std::string& answer) {
    const JobQueue::Next next = *seat.job;
    seat.job.reset();
    queue_.finish(next);
    if (answer.starts_with(kJobHopeless)) throw std::runtime_error(answer.substr(std::strlen(kJobHopeless)));
    const bool done = answer == kJobDone;
    // Readings that cannot be made fail again with each episode that needs them, and are told of there.
    if (!next.job.only_readings) {
      end_(*episodes_[next.episode], done ? "" : answer.substr(std::strlen(kJobFailed)));
      stopping_ = stopping_ || (!done && config_.fail_fast);
    }
  }

  const SweepFolder& folder_;
  const std::vector<const PlannedEpisode*>& episodes_;
  const LocalEngineConfig& config_;
  const EpisodeEnd& end_;
  JobQueue queue_;
  std::vector<Seat> seats_;
  bool stopping_ = false;
};

}  // namespace

void run_locally(const SweepFolder& folder, const std::vector<const PlannedEpisode*>& episodes,
                 const LocalEngineConfig& config, const EpisodeEnd& end, const std::function<void()>& tick) {
  folder.remove_leftovers();
  LocalEngine(folder, episodes, config, end).run(tick);
}

}  // namespace cogslam
