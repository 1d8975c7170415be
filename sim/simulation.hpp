#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sim/robot_config.hpp"
#include "sim/roller_friction.hpp"
#include "sim/truth.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// A Mecanum vehicle among walls and boxes, seen from above, in fixed steps of `RobotConfig::step`.
///
/// Wheels push by friction along their rollers (RollerFriction), motors follow set points, Box2D moves the body and
/// stops it at surfaces. The load is shared equally by the wheels, constantly. The same world, configuration, seed and
/// commands give the same truth, bit for bit.
class Simulation {
 public:
  Simulation(const World& world, const RobotConfig& config, std::uint32_t seed);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Set points of the wheel motors, held until the next command; beyond the motors' range all four are scaled down.
  void command(const WheelSpeeds& set_points);
  /// The set points that follow from `twist` of the base by inverse kinematics.
  void command(const Twist2& twist);
  /// Motors without current: the wheels roll on until the next command.
  void coast();
  /// Pushes the vehicle at its centre, once: impulse [N s] in the map frame, angular impulse [N m s].
  void push(const Eigen::Vector2d& impulse_map, double angular_impulse = 0.0);

  /// Lifts the vehicle and sets it down at rest, at once: body and route know of it, the wheels do not turn.
  void put(const Pose2& T_map_base);

  /// Moves on by one step.
  const Truth& step();
  [[nodiscard]] const Truth& truth() const;

  /// Floor contact of the four wheels in the last step.
  [[nodiscard]] const WheelContacts& wheel_contacts() const;

  /// Distance [m] from `origin` along the unit vector `direction`, both in the map frame, to the nearest surface within
  /// `max_range`, or nothing. The vehicle is not in the way. Single precision, as Box2D computes.
  [[nodiscard]] std::optional<double> cast_ray(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                               double max_range) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cogslam
