#pragma once

#include <array>
#include <optional>
#include <vector>

#include "eval/metrics/timing.hpp"
#include "slam/stage.hpp"

namespace cogslam {

/// CPU time of each stage, over all threads [s].
using StageSeconds = std::array<double, kStages>;

/// "track", "load", ...: the key of a stage in scores.json.
const char* name_of(Stage stage);

/// Adds up the CPU time that every thread spends in each stage of a filter.
class StageTimes : public StageListener {
 public:
  explicit StageTimes(int threads) : workers_(static_cast<std::size_t>(threads)) {}
  void enter(int worker, Stage stage) override;
  void leave(int worker) override;
  /// Of finished stretches; not beside a running filter.
  [[nodiscard]] StageSeconds seconds() const;

 private:
  struct alignas(64) Worker {  // a cache line each
    StageSeconds seconds{};
    std::optional<Stopwatch> running;
    Stage stage{};
  };
  std::vector<Worker> workers_;
};

}  // namespace cogslam
