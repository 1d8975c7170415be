#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "sensors/readings.hpp"

namespace cogslam {

/// A registered scan that no map holds yet.
struct WaitingScan {
  std::size_t record = 0;  ///< of the log
  Reading reading{};
};

/// The last registered scans, which no map holds yet. Tracking has matched each scan with those before it, so a map
/// that held them would only repeat its word; a map without them speaks of older times, and a loop is closed before it
/// is drawn twice. One for all particles: what differs is where their paths put the scans.
class WaitingScans {
 public:
  explicit WaitingScans(int count) : count_(static_cast<std::size_t>(count)) {}

  /// Takes the next registered scan. The oldest may enter the maps once more than `count` are here; it goes at the next
  /// call.
  void add(std::size_t record, const Reading& reading) {
    if (ripe()) scans_.pop_front();
    scans_.push_back({record, reading});
  }
  [[nodiscard]] bool ripe() const { return scans_.size() > count_; }
  [[nodiscard]] const WaitingScan& oldest() const { return scans_.front(); }
  /// Those that stay out of the maps for now, oldest first.
  [[nodiscard]] std::size_t size() const { return scans_.size() - (ripe() ? 1 : 0); }
  [[nodiscard]] const WaitingScan& operator[](std::size_t i) const { return scans_[i + (ripe() ? 1 : 0)]; }

  [[nodiscard]] std::int64_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [record, reading] : scans_) {
      sum += sizeof(WaitingScan) + (reading.scan ? reading.scan->ranges.capacity() * sizeof(float) : 0);
    }
    return static_cast<std::int64_t>(sum);
  }

 private:
  std::size_t count_;
  std::deque<WaitingScan> scans_;
};

}  // namespace cogslam
