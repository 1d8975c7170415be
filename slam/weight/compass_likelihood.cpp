#include "slam/weight/compass_likelihood.hpp"

#include <cmath>
#include <numbers>

#include "core/angle.hpp"

namespace cogslam {
namespace {

// A heading of a million lies beyond by chance; one that does is of a disturbed compass.
constexpr double kGate = 5.0;  // standard deviations

}  // namespace

double compass_sigmas(double heading, double theta_map_base, const CompassModel& model, const CompassBias& bias) {
  return std::abs(wrap_angle(heading - theta_map_base - bias.mean)) /
         std::sqrt(bias.variance + model.noise * model.noise);
}

double compass_log_likelihood(double heading, double theta_map_base, const CompassModel& model, CompassBias& bias) {
  const double innovation = wrap_angle(heading - theta_map_base - bias.mean);
  const double variance = bias.variance + model.noise * model.noise;
  if (innovation * innovation > kGate * kGate * variance) {
    return -0.5 * (kGate * kGate + std::log(2.0 * std::numbers::pi * variance));
  }
  const double gain = bias.variance / variance;
  bias.mean = wrap_angle(bias.mean + gain * innovation);
  bias.variance *= 1.0 - gain;
  return -0.5 * (innovation * innovation / variance + std::log(2.0 * std::numbers::pi * variance));
}

}  // namespace cogslam
