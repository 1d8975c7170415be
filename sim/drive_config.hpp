#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/angle.hpp"
#include "core/config.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"

namespace cogslam {

/// Where the vehicle looks on the way to a waypoint.
enum class LegHeading : std::uint8_t {
  kAlong,  ///< along the leg; it turns before it drives off
  kKeep,   ///< as it stood at the start of the leg: sideways and backwards as they come
  kFace,   ///< to a stated heading, reached before the leg ends
  kTurn,   ///< it turns all the way at a stated rate
};

/// The end of a leg, and how to get there.
struct Waypoint {
  Eigen::Vector2d p_map{0.0, 0.0};  ///< [m]
  LegHeading mode = LegHeading::kAlong;
  double heading = 0.0;    ///< in the map, for kFace [rad]
  double turn_rate = 0.0;  ///< for kTurn, counter-clockwise [rad/s]
};

/// A twist of the base, held for a while.
struct ScriptedTwist {
  Duration duration{};
  Twist2 twist{};
};

enum class DriveKind : std::uint8_t { kWaypoints, kScript };

/// What the remote operator does. Routes and scripts repeat until the run ends; an empty one stands still.
struct DriveConfig {
  DriveKind kind = DriveKind::kWaypoints;
  std::vector<Waypoint> waypoints;    ///< the first leg starts where the vehicle stands
  std::vector<ScriptedTwist> script;  ///< for kScript, as commanded: no limits below apply
  double speed = 0.3;                 ///< [m/s]
  double acceleration = 0.4;          ///< [m/s^2]
  double yaw_rate = 0.5;              ///< [rad/s]
  double yaw_acceleration = 1.0;      ///< [rad/s^2]
  double arrival = 0.02;              ///< a waypoint nearer than this is reached [m]
  double arrival_yaw = radians(2.0);  ///< a stated heading nearer than this is reached [rad]
};

/// Reads the `drive:` section.
DriveConfig read_drive_config(ConfigSection& section);

}  // namespace cogslam
