#pragma once

#include <cmath>
#include <numbers>

namespace cogslam {

/// Wraps an angle [rad] into (-pi, pi] (REP-103). Exact for angles already inside.
inline double wrap_angle(double angle) {
  if (angle > -std::numbers::pi && angle <= std::numbers::pi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * std::numbers::pi);  // in [-pi, pi]
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

/// The turn that leads from `from` to `to` the short way [rad], in (-pi, pi].
inline double angle_difference(double to, double from) { return wrap_angle(to - from); }

/// Degrees live in text files only; these two stand at that edge.
constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace cogslam
