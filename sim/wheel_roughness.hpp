#pragma once

#include <cstdint>

#include "core/mecanum_kinematics.hpp"
#include "sim/robot_config.hpp"

namespace cogslam {

/// Unevenness under the four wheels: two first-order Gauss-Markov processes per wheel, over the way it rolls, so that
/// neither the step nor the speed changes what a metre of floor does. A standing wheel keeps what it has.
class WheelRoughness {
 public:
  WheelRoughness(const RoughnessConfig& config, std::uint32_t seed);

  /// Moves on while wheel i rolls `way[i]` >= 0 [m]. `tick` is the physics step, and names the draws.
  void roll(const WheelValues& way, std::uint64_t tick);

  /// Effective radius of wheel i over its nominal radius: mean 1.
  [[nodiscard]] double radius_factor(std::size_t i) const { return 1.0 + config_.rolling * rolling_[i]; }
  /// Friction under wheel i over its nominal friction: mean 1, never negative.
  [[nodiscard]] double grip_factor(std::size_t i) const;

 private:
  RoughnessConfig config_;
  std::uint32_t seed_;
  WheelValues rolling_{};  ///< mean 0, variance 1
  WheelValues grip_{};     ///< mean 0, variance 1
};

}  // namespace cogslam
