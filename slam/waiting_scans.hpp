#pragma once

#include <cstdint>
#include <deque>

#include "sensors/readings.hpp"

namespace cogslam {

/// The last registered scans, which no map holds yet. Tracking has matched each scan with those before it, so a map
/// that held them would only repeat its word; a map without them speaks of older times, and a loop is closed before it
/// is drawn twice. One for all particles: what differs is where their paths put the scans.
class WaitingScans {
 public:
  explicit WaitingScans(int count) : count_(static_cast<std::size_t>(count)) {}

  /// Takes the next registered scan. The oldest may enter the maps once more than `count` are here; it goes at the next
  /// call.
  void add(const Reading& reading) {
    if (ripe()) scans_.pop_front();
    scans_.push_back(reading);
  }
  [[nodiscard]] bool ripe() const { return scans_.size() > count_; }
  [[nodiscard]] const Reading& oldest() const { return scans_.front(); }
  /// Those that stay out of the maps for now, oldest first.
  [[nodiscard]] std::size_t size() const { return scans_.size() - (ripe() ? 1 : 0); }
  [[nodiscard]] const Reading& operator[](std::size_t i) const { return scans_[i + (ripe() ? 1 : 0)]; }

  [[nodiscard]] std::int64_t bytes() const {
    std::size_t sum = 0;
    for (const Reading& reading : scans_) {
      sum += sizeof(Reading) + (reading.scan ? reading.scan->ranges.capacity() * sizeof(float) : 0);
    }
    return static_cast<std::int64_t>(sum);
  }

 private:
  std::size_t count_;
  std::deque<Reading> scans_;
};

}  // namespace cogslam
