#pragma once

#include <string>

#include "core/angle.hpp"
#include "core/config.hpp"
#include "core/pose2.hpp"

namespace cogslam {

/// A sweeping laser range finder. The defaults are the Hokuyo UTM-30LX (data sheet C-42-3615); what the errors mean and
/// where the figures come from: docs/decisions/0002-lidar-noise.md.
struct LidarConfig {
  int beams = 1081;                       ///< in a sweep, both ends included
  double field_of_view = radians(270.0);  ///< from the first beam to the last [rad]
  double rate_hz = 40.0;                  ///< sweeps
  double mirror_hz = 40.0;                ///< turns of the mirror: how fast a sweep is swept
  double range_min_m = 0.1;               ///< nearer things give Scan::kTooClose
  double range_max_m = 30.0;              ///< farther things give Scan::kNoReturn
  double resolution_m = 0.001;            ///< step of a reading; 0: none
  double near_limit_m = 10.0;             ///< up to here the `near` figures hold, beyond the `far` ones
  double accuracy_near_m = 0.030;         ///< an error is never larger
  double accuracy_far_m = 0.050;          ///< an error is never larger
  double sigma_near_m = 0.010;            ///< standard deviation before that bound
  double sigma_far_m = 0.0167;            ///< standard deviation before that bound
  double dropout_probability = 0.001;     ///< of a beam whose echo is lost: Scan::kNoReturn
  Pose2 T_base_lidar{};                   ///< mounting

  static LidarConfig utm30lx() { return {}; }
  static LidarConfig lms200();

  [[nodiscard]] double angle_increment() const { return field_of_view / (beams - 1); }
  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

/// `preset: utm30lx | lms200` first; any other key then changes one figure of it.
LidarConfig read_lidar_config(ConfigSection& section);

}  // namespace cogslam
