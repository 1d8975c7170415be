#pragma once

#include <cstdint>
#include <string>

#include "core/angle.hpp"
#include "core/pose2.hpp"
#include "core/rng.hpp"

namespace cogslam {

/// The errors of wheels, as the paper assumes them: systematic for a drive, and correlated along it. Each is drawn once
/// per drive but the wander, a first-order Gauss-Markov process over the way.
struct OdometryErrorConfig {
  double scale_sigma = 0.02;           ///< of the share by which every way is told too long
  double turn_share_lost = 0.08;       ///< of every turn; the log mit-csail loses as much
  double drift_least = radians(0.5);   ///< heading per metre, to a side drawn at random [rad/m]
  double drift_most = radians(1.0);    ///< [rad/m]
  double wander_sigma = radians(0.3);  ///< of the heading per metre, about the drift [rad/m]
  double wander_length_m = 10.0;       ///< over which the wander forgets

  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

/// The odometry of one drive.
class FaultyOdometry {
 public:
  /// `config` must pass its check().
  FaultyOdometry(const OdometryErrorConfig& config, std::uint32_t seed);

  /// What odometry says of a true motion, which should be short: errors are taken as constant over it.
  Pose2 measure(const Pose2& T_before_now);

 private:
  OdometryErrorConfig config_;
  Rng rng_;
  double scale_ = 1.0;
  double drift_ = 0.0;   // [rad/m]
  double wander_ = 0.0;  // [rad/m]
};

}  // namespace cogslam
