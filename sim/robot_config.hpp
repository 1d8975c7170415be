#pragma once

#include "core/config.hpp"
#include "core/mecanum_kinematics.hpp"
#include "core/time.hpp"

namespace cogslam {

/// Speed controller of one wheel: PI with a torque limit.
struct MotorConfig {
  double kp = 0.08;         ///< [N m / (rad/s)]
  double ki = 1.0;          ///< [N m / rad]
  double max_torque = 0.6;  ///< [N m]
  double max_speed = 40.0;  ///< of a wheel set point [rad/s]; faster twists are scaled down as a whole
};

/// How uneven the floor and the rollers are. Both parts vary from wheel to wheel and along the way.
struct RoughnessConfig {
  double rolling = 0.02;  ///< standard deviation of the effective wheel radius, share of the radius
  double grip = 0.1;      ///< standard deviation of the friction, share of the friction
  double length = 0.05;   ///< way over which either is forgotten (to 1/e) [m]
};

/// A vehicle on four Mecanum wheels. Defaults: a small indoor robot (assumed values, no particular product).
struct RobotConfig {
  MecanumGeometry geometry{};
  double length = 0.42;         ///< of the footprint, along x [m]
  double width = 0.38;          ///< of the footprint, along y [m]
  double mass = 6.0;            ///< wheels included [kg]
  double inertia = 0.125;       ///< about the vertical axis [kg m^2]
  double wheel_inertia = 1e-3;  ///< of one wheel with its motor [kg m^2]
  double friction = 0.6;        ///< between roller and floor
  double wall_friction = 0.3;   ///< between body and walls
  MotorConfig motor{};
  RoughnessConfig roughness{};
  Duration step = Duration::from_seconds(0.001);  ///< of the physics

  /// Throws InputError (without a place) where values do not go together.
  void check() const;
};

/// Reads the `robot:` section.
RobotConfig read_robot_config(ConfigSection& section);

}  // namespace cogslam
