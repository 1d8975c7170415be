#include "sim/robot_config.hpp"

#include "core/error.hpp"

namespace cogslam {
namespace {

void read_body(ConfigSection& section, RobotConfig& config) {
  section.read("wheel_radius_m", config.geometry.wheel_radius, {1e-3, 2.0});
  section.read("half_length_m", config.geometry.half_length, {1e-3, 2.5});
  section.read("half_width_m", config.geometry.half_width, {1e-3, 2.5});
  section.read("length_m", config.length, {0.05, 5.0});
  section.read("width_m", config.width, {0.05, 5.0});
  section.read("mass_kg", config.mass, {0.01, 1e5});
  section.read("inertia_kg_m2", config.inertia, {1e-6, 1e6});
  section.read("wheel_inertia_kg_m2", config.wheel_inertia, {1e-8, 1e4});
  section.read("friction", config.friction, {0.0, 2.0});
  section.read("wall_friction", config.wall_friction, {0.0, 2.0});
}

void read_motor(ConfigSection section, MotorConfig& motor) {
  section.read("kp_n_m_s_per_rad", motor.kp, {0.0, 1e6});
  section.read("ki_n_m_per_rad", motor.ki, {0.0, 1e6});
  section.read("max_torque_n_m", motor.max_torque, {0.0, 1e6});
  section.read("max_speed_rad_s", motor.max_speed, {1e-3, 1e4});
}

void read_roughness(ConfigSection section, RoughnessConfig& roughness) {
  section.read("rolling", roughness.rolling, {0.0, 0.2});
  section.read("grip", roughness.grip, {0.0, 0.5});
  section.read("length_m", roughness.length, {1e-4, 1000.0});
}

}  // namespace

void RobotConfig::check() const {
  if (2.0 * geometry.half_length > length || 2.0 * geometry.half_width > width) {
    throw InputError(
        "the wheels stand outside the footprint, expected half_length_m <= length_m / 2 and "
        "half_width_m <= width_m / 2");
  }
  if (step.ns <= 0 || step > Duration::from_seconds(0.02)) {
    throw InputError("a physics step must be longer than 0 and at most 20 ms");
  }
  // The controller is integrated explicitly: a wheel alone, off the floor, must not be driven past its set point.
  if (motor.kp * step.seconds() > wheel_inertia) {
    throw InputError("the motor gain is too high for the physics step, expected kp * step <= wheel inertia");
  }
}

RobotConfig read_robot_config(ConfigSection& section) {
  RobotConfig config;
  read_body(section, config);
  read_motor(section.section("motor"), config.motor);
  read_roughness(section.section("roughness"), config.roughness);
  double step_ms = config.step.seconds() * 1e3;
  section.read("step_ms", step_ms, {0.1, 20.0});
  config.step = Duration::from_seconds(step_ms * 1e-3);
  try {
    config.check();
  } catch (const InputError& error) {
    section.fail("", error.what());
  }
  return config;
}

}  // namespace cogslam
