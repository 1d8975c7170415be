#include "eval/metrics/stage_times.hpp"

namespace cogslam {

const char* name_of(Stage stage) {
  switch (stage) {
    case Stage::kTrack:
      return "track";
    case Stage::kPrepare:
      return "prepare";
    case Stage::kLoad:
      return "load";
    case Stage::kWeigh:
      return "weigh";
    case Stage::kWrite:
      return "write";
    case Stage::kSettle:
      return "settle";
    case Stage::kResample:
      return "resample";
  }
  return "";
}

void StageTimes::enter(int worker, Stage stage) {
  leave(worker);
  Worker& own = workers_[static_cast<std::size_t>(worker)];
  own.stage = stage;
  own.running.emplace(Clock::kThreadCpu);
}

void StageTimes::leave(int worker) {
  Worker& own = workers_[static_cast<std::size_t>(worker)];
  if (!own.running) return;
  own.seconds[static_cast<std::size_t>(own.stage)] += own.running->seconds();
  own.running.reset();
}

StageSeconds StageTimes::seconds() const {
  StageSeconds sum{};
  for (const Worker& worker : workers_) {
    for (std::size_t s = 0; s < kStages; ++s) sum[s] += worker.seconds[s];
  }
  return sum;
}

}  // namespace cogslam
