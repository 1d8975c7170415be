#pragma once

namespace cogslam {

/// A compass with white noise about a constant bias that nobody knows.
struct CompassModel {
  bool used = true;
  double noise = 0.0349;       ///< standard deviation of one heading [rad] (2 deg)
  double bias_sigma = 0.0302;  ///< of the unknown bias before any heading [rad] (3 deg / sqrt 3, as if uniform)
};

/// What a particle believes of the compass's bias: a Gaussian. Given the path, the bias is linear in the headings, so a
/// Kalman filter per particle integrates it out exactly (Rao-Blackwell), as the map is.
struct CompassBias {
  double mean = 0.0;      ///< [rad]
  double variance = 0.0;  ///< [rad^2]
};

/// How far a heading lies from the expected one, in standard deviations of the two together.
double compass_sigmas(double heading, double theta_map_base, const CompassModel& model, const CompassBias& bias);

/// log p(heading | pose, earlier headings), and the bias learns from it. A heading over 5 standard deviations off
/// counts as one at 5, and the bias learns nothing from it: iron nearby must not teach it.
double compass_log_likelihood(double heading, double theta_map_base, const CompassModel& model, CompassBias& bias);

}  // namespace cogslam
