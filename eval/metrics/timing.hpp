#pragma once

#include <cstdint>
#include <optional>

// The only place outside bench/ that reads clocks and asks the system for memory. Nothing here may reach a score.

namespace cogslam {

enum class Clock : std::uint8_t {
  kWall,        ///< monotonic time
  kProcessCpu,  ///< CPU time of all threads of the process
  kThreadCpu,   ///< CPU time of the calling thread: start and read it on the same one
};

/// Runs from its making.
class Stopwatch {
 public:
  explicit Stopwatch(Clock clock);
  [[nodiscard]] double seconds() const;  ///< since the making

 private:
  Clock clock_;
  double start_;
};

/// Adds up the stretches between `start` and `stop`.
class StretchTimer {
 public:
  explicit StretchTimer(Clock clock) : clock_(clock) {}
  void start() { running_.emplace(clock_); }
  void stop();                                           ///< without `start` breaks the contract
  [[nodiscard]] double seconds() const { return sum_; }  ///< of finished stretches

 private:
  Clock clock_;
  std::optional<Stopwatch> running_;
  double sum_ = 0.0;
};

/// Memory of this process that is in RAM now, and the most there was since the start or `reset_rss_peak` [bytes].
/// Nothing where the system does not tell (no /proc).
std::optional<std::uint64_t> rss_bytes();
std::optional<std::uint64_t> rss_peak_bytes();

/// Lets the peak start anew from the present size; false where the system does not allow it.
bool reset_rss_peak();

}  // namespace cogslam
