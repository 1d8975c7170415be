#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "sensors/faults/stream_fault.hpp"

namespace cogslam {

/// The wire between one sensor and whoever listens, with its faults. `Sample` has a `stamp`.
template <class Sample>
class FaultyStream {
 public:
  FaultyStream(std::vector<StreamFault> faults, std::uint32_t seed) : seed_(seed) {
    for (StreamFault& fault : faults) stages_.push_back({fault, {}});
  }

  /// What arrives in place of sample number `index`, in the order of their stamps, each fault acting on what the one
  /// listed before it let through; nothing where the sample is lost. The stamp is always that of the sample.
  std::optional<Sample> pass(Sample sample, std::uint64_t index) {
    std::optional<Sample> out = std::move(sample);
    for (Stage& stage : stages_) {
      if (!out) break;
      out = stage.pass(std::move(*out), seed_, index);
    }
    return out;
  }

 private:
  struct Stage {
    StreamFault fault;
    std::deque<Sample> past;  ///< of a frozen one the last before the span, of a late one those that may still count

    std::optional<Sample> pass(Sample sample, std::uint32_t seed, std::uint64_t index) {
      switch (fault.kind) {
        case StreamFaultKind::kDropout:
          if (fault.span.holds(sample.stamp) && is_lost(fault, seed, index)) return std::nullopt;
          return sample;
        case StreamFaultKind::kFrozen:
          if (!fault.span.holds(sample.stamp) || past.empty()) {  // nothing before the span: the first one freezes
            past.assign(1, sample);
            return sample;
          }
          return stamped(past.back(), sample.stamp);
        case StreamFaultKind::kLate:
          return late(std::move(sample));
      }
      return sample;
    }

    /// The newest that is at least `latency` old; nothing while there is none.
    std::optional<Sample> late(Sample sample) {
      const Time stamp = sample.stamp;
      const bool lasts = fault.span.holds(stamp);
      past.push_back(std::move(sample));
      while (past.size() > 1 && past[1].stamp <= stamp - fault.latency) past.pop_front();
      if (!lasts) return past.back();
      if (past.front().stamp > stamp - fault.latency) return std::nullopt;
      return stamped(past.front(), stamp);
    }

    static Sample stamped(Sample sample, Time stamp) {
      sample.stamp = stamp;
      return sample;
    }
  };

  std::uint32_t seed_;
  std::vector<Stage> stages_;
};

}  // namespace cogslam
