#pragma once

#include <cstdint>

#include "core/hash.hpp"
#include "sim/simulation.hpp"

namespace cogslam {

/// A vehicle on a perfectly even floor.
inline RobotConfig even_robot() {
  RobotConfig config;
  config.roughness.rolling = 0.0;
  config.roughness.grip = 0.0;
  return config;
}

inline void run_for(Simulation& simulation, double seconds) {
  const Time end = simulation.truth().time + Duration::from_seconds(seconds);
  while (simulation.truth().time < end) simulation.step();
}

/// Kinetic energy of body and wheels [J].
inline double kinetic_energy(const RobotConfig& config, const Truth& truth) {
  const Twist2& v = truth.twist;
  double energy = 0.5 * config.mass * (v.x * v.x + v.y * v.y) + 0.5 * config.inertia * v.theta * v.theta;
  for (const double w : truth.wheel_speeds) energy += 0.5 * config.wheel_inertia * w * w;
  return energy;
}

inline void add_state(Hash& hash, const Truth& truth) {
  hash.add(truth.time.ns).add(truth.T_map_base.x).add(truth.T_map_base.y).add(truth.T_map_base.theta);
  for (const double angle : truth.wheel_angles) hash.add(angle);
}

}  // namespace cogslam
