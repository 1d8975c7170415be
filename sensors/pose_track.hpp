#pragma once

#include <deque>

#include "core/time.hpp"
#include "sim/truth.hpp"

namespace cogslam {

/// The state a share `w` in [0, 1] of the way from one step of the simulation to the next: position, heading, twist and
/// wheels linear in time. At 1 kHz, 1 m/s and 2 rad/s this leaves the true arc by less than 1e-6 m.
Truth interpolate(const Truth& from, const Truth& to, double w);

/// The true states of the last moments, so that a sensor can be read at its own time, between two steps.
class PoseTrack {
 public:
  /// Remembers at least the last `memory`.
  explicit PoseTrack(Duration memory) : memory_(memory) {}

  /// Each state comes later than the one before.
  void push(const Truth& truth);

  /// Two neighbouring states, from.time <= t <= to.time; the same one twice where only one is known.
  struct Leg {
    const Truth& from;
    const Truth& to;
  };
  /// `t` must lie within [oldest, newest]. The leg is good until the next push.
  [[nodiscard]] Leg leg_at(Time t) const;
  [[nodiscard]] Truth at(Time t) const;

  [[nodiscard]] bool empty() const { return states_.empty(); }
  [[nodiscard]] Time oldest() const { return states_.front().time; }
  [[nodiscard]] Time newest() const { return states_.back().time; }

 private:
  Duration memory_;
  std::deque<Truth> states_;
};

}  // namespace cogslam
