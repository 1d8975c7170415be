#include "sensors/compass.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/support/statistics.hpp"

namespace cogslam {
namespace {

constexpr double kPi = std::numbers::pi;

/// Heading errors [rad] of `count` samples.
std::vector<double> errors(const Compass& compass, double heading, int count) {
  std::vector<double> out;
  for (int n = 0; n < count; ++n)
    out.push_back(
        angle_difference(compass.sample({1.0, 2.0, heading}, {}, static_cast<std::uint64_t>(n)).heading, heading));
  return out;
}

TEST(Compass, BearingsAreClockwiseFromNorth) {
  EXPECT_NEAR(heading_of_bearing(0.0, 0.0), kPi / 2, 1e-15);    // north is +y
  EXPECT_NEAR(heading_of_bearing(kPi / 2, 0.0), 0.0, 1e-15);    // east is +x
  EXPECT_NEAR(heading_of_bearing(kPi, 0.0), -kPi / 2, 1e-15);   // south
  EXPECT_NEAR(heading_of_bearing(1.5 * kPi, 0.0), kPi, 1e-15);  // west
  EXPECT_NEAR(bearing_of_heading(0.0, 0.0), kPi / 2, 1e-15);
}

TEST(Compass, DeclinationTurnsMagneticIntoTrueNorth) {
  // Magnetic north lies 10 degrees east: who walks to it heads 80 degrees from east.
  EXPECT_NEAR(heading_of_bearing(0.0, radians(10.0)), radians(80.0), 1e-15);
  EXPECT_NEAR(bearing_of_heading(radians(90.0), radians(10.0)), radians(350.0), 1e-12);
}

TEST(Compass, HeadingAndBearingAreInverse) {
  for (int i = -1000; i <= 1000; ++i) {
    const double heading = wrap_angle(0.01 * i), declination = 0.003 * i;
    const double bearing = bearing_of_heading(heading, declination);
    EXPECT_GE(bearing, 0.0);
    EXPECT_LT(bearing, 2.0 * kPi);
    EXPECT_NEAR(angle_difference(heading_of_bearing(bearing, declination), heading), 0.0, 1e-12);
  }
  EXPECT_LT(bearing_of_heading(kPi / 2 + 1e-17, 1e-17), 2.0 * kPi);
}

TEST(Compass, NoiseIsWhiteWithTheStatedSpreadAroundTheBias) {
  CompassConfig config;
  config.bias = radians(1.5);
  config.declination = radians(4.0);
  for (const double heading : {0.3, 3.14, -1.6}) {
    const auto e = errors(Compass(config, 11), heading, 20000);
    const Moments m = moments(e);
    EXPECT_NEAR(m.mean, radians(1.5), 5.0 * config.noise / std::sqrt(m.count));
    EXPECT_NEAR(m.variance / (config.noise * config.noise), 1.0, 5.0 * std::sqrt(2.0 / m.count));
    const std::vector<double> before(e.begin(), e.end() - 1), after(e.begin() + 1, e.end());
    EXPECT_LT(std::abs(correlation(before, after)), 5.0 / std::sqrt(m.count));
  }
}

TEST(Compass, BiasIsOnePerRunAndEvenWithinItsBound) {
  std::vector<double> biases;
  for (std::uint32_t seed = 0; seed < 5000; ++seed) biases.push_back(Compass(CompassConfig{}, seed).bias());
  const Moments m = moments(biases);
  const double bound = radians(3.0);
  EXPECT_LE(m.max, bound);
  EXPECT_GE(m.min, -bound);
  EXPECT_GT(m.max, 0.99 * bound);
  EXPECT_NEAR(m.mean, 0.0, 5.0 * bound / std::sqrt(3.0 * m.count));
  EXPECT_NEAR(m.variance, bound * bound / 3.0, 0.05 * bound * bound);
  EXPECT_EQ(Compass(CompassConfig{}, 7).bias(), Compass(CompassConfig{}, 7).bias());
}

TEST(Compass, DrawsTheSameInAnyOrder) {
  const Compass a(CompassConfig{}, 3), b(CompassConfig{}, 3);
  const double third = a.sample({}, {}, 3).heading, fourth = a.sample({}, {}, 4).heading;
  EXPECT_EQ(b.sample({}, {}, 4).heading, fourth);
  EXPECT_EQ(b.sample({}, {}, 3).heading, third);
  EXPECT_NE(third, fourth);
}

TEST(Compass, ReadsAStatedBiasInDegrees) {
  ConfigSection s = ConfigSection::parse("noise_deg: 1\nbias_deg: -2\ndeclination_deg: 3\n", "c.yaml");
  const CompassConfig c = read_compass_config(s);
  s.finish();
  EXPECT_NEAR(c.noise, radians(1.0), 1e-15);
  EXPECT_NEAR(Compass(c, 5).bias(), radians(-2.0), 1e-15);
  EXPECT_NEAR(c.declination, radians(3.0), 1e-15);
}

}  // namespace
}  // namespace cogslam
