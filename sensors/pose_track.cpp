#include "sensors/pose_track.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/check.hpp"

namespace cogslam {
namespace {

double mix(double a, double b, double w) { return a + w * (b - a); }

}  // namespace

Truth interpolate(const Truth& from, const Truth& to, double w) {
  Truth out = w < 1.0 ? from : to;
  const Pose2 &a = from.T_map_base, &b = to.T_map_base;
  out.time = from.time + Duration{std::llround(w * static_cast<double>((to.time - from.time).ns))};
  out.T_map_base = {mix(a.x, b.x, w), mix(a.y, b.y, w), wrap_angle(a.theta + w * angle_difference(b.theta, a.theta))};
  out.twist = {mix(from.twist.x, to.twist.x, w), mix(from.twist.y, to.twist.y, w),
               mix(from.twist.theta, to.twist.theta, w)};
  for (std::size_t i = 0; i < 4; ++i) {
    out.wheel_speeds[i] = mix(from.wheel_speeds[i], to.wheel_speeds[i], w);
    out.wheel_angles[i] = mix(from.wheel_angles[i], to.wheel_angles[i], w);
  }
  return out;
}

void PoseTrack::push(const Truth& truth) {
  EXPECTS(states_.empty() || truth.time > newest());
  states_.push_back(truth);
  while (states_.size() > 2 && states_[1].time <= newest() - memory_) states_.pop_front();
}

PoseTrack::Leg PoseTrack::leg_at(Time t) const {
  EXPECTS(!states_.empty() && t >= oldest() && t <= newest());
  const auto to =
      std::lower_bound(states_.begin(), states_.end(), t, [](const Truth& s, Time at) { return s.time < at; });
  return {to == states_.begin() ? *to : *(to - 1), *to};
}

Truth PoseTrack::at(Time t) const {
  const auto [from, to] = leg_at(t);
  const Duration span = to.time - from.time;
  Truth out = interpolate(from, to, span.ns > 0 ? (t - from.time).seconds() / span.seconds() : 0.0);
  out.time = t;
  return out;
}

}  // namespace cogslam
