#include "sensors/floor_light.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

enum Stream : std::uint32_t { kDrift = 0, kStep = 1 };

/// Uniform in (-1, 1), one value for each whole number.
double knot(std::uint32_t seed, Stream stream, double index) {
  return Rng({seed, Purpose::kCameraLight, stream, static_cast<std::uint64_t>(index)}).uniform(-1.0, 1.0);
}

}  // namespace

double light_gain(const FloorLightConfig& config, std::uint32_t seed, Time time) {
  EXPECTS(time.ns >= 0);
  double gain = 1.0;
  if (config.drift > 0.0) {
    const double t = time.seconds() / config.drift_period, i = std::floor(t), w = t - i;
    const double smooth = w * w * (3.0 - 2.0 * w);
    gain += config.drift * ((1.0 - smooth) * knot(seed, kDrift, i) + smooth * knot(seed, kDrift, i + 1.0));
  }
  if (config.step > 0.0) gain += config.step * knot(seed, kStep, std::floor(time.seconds() / config.step_period));
  return std::max(gain, 0.0);
}

std::vector<float> vignette_gains(const FloorLightConfig& config, int width, int height) {
  const double corner = 0.25 * (width * width + height * height);
  std::vector<float> gains;
  gains.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double x = column + 0.5 - 0.5 * width, y = row + 0.5 - 0.5 * height;
      gains.push_back(static_cast<float>(1.0 - config.vignette * (x * x + y * y) / corner));
    }
  }
  return gains;
}

}  // namespace cogslam
