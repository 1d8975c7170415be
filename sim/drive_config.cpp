#include "sim/drive_config.hpp"

namespace cogslam {
namespace {

void require(const ConfigSection& section, const std::string& key) {
  if (!section.has(key)) section.fail(key, "'" + key + "' is missing, expected a number");
}

Waypoint read_waypoint(ConfigSection section) {
  Waypoint waypoint;
  require(section, "x_m");
  section.read("x_m", waypoint.p_map.x(), {-1e4, 1e4});
  require(section, "y_m");
  section.read("y_m", waypoint.p_map.y(), {-1e4, 1e4});
  section.read_choice("heading", waypoint.mode,
                      {{"along", LegHeading::kAlong},
                       {"keep", LegHeading::kKeep},
                       {"face", LegHeading::kFace},
                       {"turn", LegHeading::kTurn}});
  if (waypoint.mode == LegHeading::kFace) {
    require(section, "heading_deg");
    section.read_degrees("heading_deg", waypoint.heading, {-360.0, 360.0});
  }
  if (waypoint.mode == LegHeading::kTurn) {
    require(section, "turn_rate_deg_s");
    section.read_degrees("turn_rate_deg_s", waypoint.turn_rate, {-360.0, 360.0});
  }
  return waypoint;
}

ScriptedTwist read_scripted_twist(ConfigSection section) {
  ScriptedTwist scripted;
  double seconds = 0.0;
  require(section, "duration_s");
  section.read("duration_s", seconds, {0.001, 1e6});
  scripted.duration = Duration::from_seconds(seconds);
  section.read("vx_m_s", scripted.twist.x, {-5.0, 5.0});
  section.read("vy_m_s", scripted.twist.y, {-5.0, 5.0});
  section.read_degrees("omega_deg_s", scripted.twist.theta, {-720.0, 720.0});
  return scripted;
}

}  // namespace

DriveConfig read_drive_config(ConfigSection& section) {
  DriveConfig config;
  section.read_choice("kind", config.kind, {{"waypoints", DriveKind::kWaypoints}, {"script", DriveKind::kScript}});
  if (config.kind == DriveKind::kScript) {
    for (ConfigSection& part : section.sections("script")) config.script.push_back(read_scripted_twist(part));
    if (config.script.empty())
      section.fail("script", "drive: nothing to drive, expected a list of {duration_s, vx_m_s, ...} under script");
    return config;
  }
  section.read("speed_m_s", config.speed, {0.01, 5.0});
  section.read("acceleration_m_s2", config.acceleration, {0.01, 10.0});
  section.read_degrees("yaw_rate_deg_s", config.yaw_rate, {1.0, 360.0});
  section.read_degrees("yaw_acceleration_deg_s2", config.yaw_acceleration, {1.0, 1000.0});
  section.read("arrival_m", config.arrival, {0.005, 1.0});
  section.read_degrees("arrival_deg", config.arrival_yaw, {0.2, 90.0});
  for (ConfigSection& part : section.sections("waypoints")) config.waypoints.push_back(read_waypoint(part));
  if (config.waypoints.empty())
    section.fail("waypoints", "drive: nowhere to drive, expected a list of {x_m, y_m, ...} under waypoints");
  return config;
}

}  // namespace cogslam
