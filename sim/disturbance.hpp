#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/config.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"
#include "sim/simulation.hpp"

namespace cogslam {

/// A blow from outside, at the centre of the vehicle.
struct Push {
  Time at{};
  Eigen::Vector2d impulse_map{0.0, 0.0};  ///< [N s]
  double angular_impulse = 0.0;           ///< [N m s], counter-clockwise
};

/// The vehicle is lifted, carried elsewhere and set down at rest, all in one moment.
struct Kidnapping {
  Time at{};
  Pose2 T_map_base{};  ///< where it is set down
};

/// What is done to the vehicle against its will.
struct DisturbanceConfig {
  std::vector<Push> pushes;
  std::vector<Kidnapping> kidnappings;
};

/// `at_s`, `impulse_n_s`, `angular_impulse_n_m_s`. InputError where neither impulse is over 0.
Push read_push(ConfigSection& section);

/// `at_s`, `x_m`, `y_m`, `heading_deg`. Whether there is room to stand is the caller's to check.
Kidnapping read_kidnapping(ConfigSection& section);

/// Does it, each at its moment.
class Disturbances {
 public:
  explicit Disturbances(DisturbanceConfig config) : config_(std::move(config)) {}

  /// Applies what fell due since the last call, the moment of the simulation's truth included.
  void apply(Simulation& simulation);

 private:
  DisturbanceConfig config_;
  Time done_{-1};  ///< up to here
};

}  // namespace cogslam
