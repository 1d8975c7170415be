#pragma once

#include <cstdint>

#include "core/time.hpp"

namespace cogslam {

/// The moments at which a sensor of a constant rate is read: n / rate after time 0, n = 0, 1, ... A rate of 0 is never.
class Schedule {
 public:
  /// `rate_hz` >= 0.
  explicit Schedule(double rate_hz) : rate_hz_(rate_hz) {}

  /// Calls take(stamp, n) for every moment up to `now`, itself included, that has not been taken yet.
  template <class Take>
  void take_until(Time now, Take&& take) {
    if (rate_hz_ <= 0.0) return;
    for (; due(next_) <= now; ++next_) take(due(next_), next_);
  }

  /// Gives up the moments before `start`.
  void start_at(Time start) {
    take_until(start - Duration{1}, [](Time, std::uint64_t) {});
  }

  [[nodiscard]] Time due(std::uint64_t n) const { return Time::from_seconds(static_cast<double>(n) / rate_hz_); }

 private:
  double rate_hz_;
  std::uint64_t next_ = 0;
};

}  // namespace cogslam
