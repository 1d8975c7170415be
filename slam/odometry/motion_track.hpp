#pragma once

#include <deque>

#include "sensors/readings.hpp"

namespace cogslam {

/// The way of the base as odometry saw it: motions end to end, each at a constant twist.
class MotionTrack {
 public:
  /// Adds the motion from the end of the track to `end`. The first call of all needs start() before it.
  void add(const MotionIncrement& motion, Time end);
  void start(Time stamp) { begin_ = end_ = stamp; }

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  [[nodiscard]] Time end() const { return end_; }

  /// Motion from `from` to `to` >= `from`; the share of a piece that is taken has that share of its covariance. The
  /// source is kWheel if any piece is. Before the track begins and after it ends its first and last twist go on.
  [[nodiscard]] MotionIncrement between(Time from, Time to) const;

  /// Velocity at a moment; of the first or last piece outside the track. Zero where the track is empty.
  [[nodiscard]] Twist2 twist_at(Time stamp) const;

  /// Forgets the pieces that end before `stamp`, but never the last.
  void forget_before(Time stamp);

 private:
  struct Piece {
    Time begin{};
    Time end{};
    MotionIncrement motion{};
  };

  Time begin_{};
  Time end_{};
  std::deque<Piece> pieces_;
};

}  // namespace cogslam
