#include "slam/odometry/motion_track.hpp"

#include <algorithm>

#include "core/check.hpp"

namespace cogslam {

void MotionTrack::add(const MotionIncrement& motion, Time end) {
  EXPECTS(end > end_);
  pieces_.push_back({end_, end, motion});
  end_ = end;
}

MotionIncrement MotionTrack::between(Time from, Time to) const {
  EXPECTS(from <= to && !pieces_.empty());
  MotionIncrement total{.T_before_now = {}, .source = pieces_.front().motion.source};
  bool first = true;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    // The outermost pieces reach as far as they are asked to.
    const Time begin = i == 0 ? from : std::max(from, piece.begin);
    const Time end = i + 1 == pieces_.size() ? to : std::min(to, piece.end);
    if (begin >= end) continue;
    const double share = (end - begin).seconds() / (piece.end - piece.begin).seconds();
    const Pose2 T = Pose2::exp(share * piece.motion.T_before_now.log());
    total.covariance = compose_covariance(total.covariance, T, share * piece.motion.covariance);
    total.T_before_now = total.T_before_now * T;
    const bool wheel = piece.motion.source == MotionSource::kWheel;
    if (first || wheel) total.source = piece.motion.source;
    first = false;
  }
  return total;
}

Twist2 MotionTrack::twist_at(Time stamp) const {
  if (pieces_.empty()) return {};
  const auto later = std::find_if(pieces_.begin(), pieces_.end(), [&](const Piece& p) { return stamp < p.end; });
  const Piece& piece = later == pieces_.end() ? pieces_.back() : *later;
  return (1.0 / (piece.end - piece.begin).seconds()) * piece.motion.T_before_now.log();
}

void MotionTrack::forget_before(Time stamp) {
  while (pieces_.size() > 1 && pieces_.front().end <= stamp) pieces_.pop_front();
}

}  // namespace cogslam
