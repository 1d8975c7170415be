#include "sim/disturbance.hpp"

#include <string>

#include "core/angle.hpp"

namespace cogslam {
namespace {

constexpr Range kAnywhere{-1e4, 1e4};  // [m]

void require(const ConfigSection& section, const std::string& key, const char* expected) {
  if (!section.has(key)) section.fail(key, "'" + key + "' is missing, expected " + expected);
}

Time read_moment(ConfigSection& section) {
  double seconds = 0.0;
  require(section, "at_s", "a number");
  section.read("at_s", seconds, {0.0, 1e6});
  return Time::from_seconds(seconds);
}

}  // namespace

Push read_push(ConfigSection& section) {
  Push push{.at = read_moment(section)};
  section.read("impulse_n_s", push.impulse_map, {-1e4, 1e4});
  section.read("angular_impulse_n_m_s", push.angular_impulse, {-1e3, 1e3});
  if (push.impulse_map.isZero(0.0) && push.angular_impulse == 0.0) {
    section.fail("impulse_n_s", "a push without impulse, expected impulse_n_s or angular_impulse_n_m_s other than 0");
  }
  return push;
}

Kidnapping read_kidnapping(ConfigSection& section) {
  Kidnapping kidnapping{.at = read_moment(section)};
  require(section, "x_m", "a number");
  section.read("x_m", kidnapping.T_map_base.x, kAnywhere);
  require(section, "y_m", "a number");
  section.read("y_m", kidnapping.T_map_base.y, kAnywhere);
  section.read_degrees("heading_deg", kidnapping.T_map_base.theta, {-360.0, 360.0});
  kidnapping.T_map_base.theta = wrap_angle(kidnapping.T_map_base.theta);
  return kidnapping;
}

void Disturbances::apply(Simulation& simulation) {
  const Time now = simulation.truth().time;
  const auto due = [&](Time at) { return at > done_ && at <= now; };
  for (const Push& push : config_.pushes) {
    if (due(push.at)) simulation.push(push.impulse_map, push.angular_impulse);
  }
  for (const Kidnapping& kidnapping : config_.kidnappings) {
    if (due(kidnapping.at)) simulation.put(kidnapping.T_map_base);
  }
  done_ = now;
}

}  // namespace cogslam
