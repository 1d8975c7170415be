#include "eval/metrics/timing.hpp"

#include <ctime>
#include <fstream>
#include <limits>
#include <string>

#include "core/check.hpp"

namespace cogslam {
namespace {

double now(Clock clock) {
  const clockid_t id = clock == Clock::kWall         ? CLOCK_MONOTONIC
                       : clock == Clock::kProcessCpu ? CLOCK_PROCESS_CPUTIME_ID
                                                     : CLOCK_THREAD_CPUTIME_ID;
  timespec time{};
  ENSURES(clock_gettime(id, &time) == 0);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A line "Name:   1234 kB" of /proc/self/status. Not getrusage: its peak is inherited from the parent process.
std::optional<std::uint64_t> status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (std::uint64_t kib = 0; word == name && status >> kib) return kib * 1024;
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::nullopt;
}

}  // namespace

Stopwatch::Stopwatch(Clock clock) : clock_(clock), start_(now(clock)) {}

double Stopwatch::seconds() const { return now(clock_) - start_; }

void StretchTimer::stop() {
  EXPECTS(running_.has_value());
  sum_ += running_->seconds();
  running_.reset();
}

std::optional<std::uint64_t> rss_bytes() { return status_bytes("VmRSS:"); }

std::optional<std::uint64_t> rss_peak_bytes() { return status_bytes("VmHWM:"); }

bool reset_rss_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;  // proc(5): resets VmHWM to the present VmRSS
  return file.good();
}

}  // namespace cogslam
