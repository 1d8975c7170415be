#include "sensors/faults/compass_deflection.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "core/rng.hpp"
#include "sensors/compass.hpp"

namespace cogslam {
namespace {

constexpr double kPi = std::numbers::pi;

double deflection(const Magnet& magnet, const Eigen::Vector2d& p_map, double declination = 0.0) {
  return compass_deflection(std::span(&magnet, 1), p_map, declination);
}

TEST(CompassDeflection, IsNoneWithoutMagnetsAndFarAway) {
  EXPECT_EQ(compass_deflection({}, {1.0, 2.0}, 0.3), 0.0);
  EXPECT_NEAR(deflection({{0.0, 0.0}, 0.5, 0.7}, {300.0, 100.0}), 0.0, 1e-8);
}

TEST(CompassDeflection, FallsWithTheCubeOfTheDistance) {
  Rng rng({1, Purpose::kWorld, 0, 0});
  for (int i = 0; i < 100; ++i) {
    const Magnet magnet{{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}, 0.4, rng.uniform(-kPi, kPi)};
    const double angle = rng.uniform(-kPi, kPi);
    const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
    const double near = deflection(magnet, magnet.centre + 10.0 * u),
                 far = deflection(magnet, magnet.centre + 20.0 * u);
    EXPECT_NEAR(near, 8.0 * far, 1e-7) << i;
  }
}

TEST(CompassDeflection, TurnsTheNeedleByHalfARightAngleBesideAMagnetAtItsReach) {
  // Beside a moment to the west the field points east, as strong as the earth's to the north.
  const Magnet magnet{{0.0, 0.0}, 0.5, kPi};
  EXPECT_NEAR(deflection(magnet, {0.0, 0.5}), -kPi / 4, 1e-12);
  // On its axis it is twice as strong, and points along the moment.
  EXPECT_NEAR(deflection(magnet, {0.5, 0.0}), std::atan(2.0), 1e-12);
}

TEST(CompassDeflection, VanishesWhereTheFieldPointsNorthToo) {
  EXPECT_NEAR(deflection({{0.0, 0.0}, 0.5, kPi / 2}, {0.0, 0.8}), 0.0, 1e-12);
  EXPECT_NEAR(deflection({{0.0, 0.0}, 0.5, kPi / 2 - 0.2}, {0.8 * std::sin(0.2), 0.8 * std::cos(0.2)}, 0.2), 0.0,
              1e-12);
}

TEST(CompassDeflection, TakesFromTheHeadingWhatTheNeedleTurns) {
  CompassConfig config;
  config.noise = 0.0;
  config.bias = 0.0;
  config.declination = 0.1;
  const std::vector<Magnet> magnets{{{0.3, 0.1}, 0.4, 1.0}};
  for (const Pose2& pose : {Pose2{1.0, 0.2, 0.3}, Pose2{-0.4, 0.6, -2.0}, Pose2{0.3, 0.9, 3.0}}) {
    const double turned = compass_deflection(magnets, pose.position(), 0.1);
    const double heading = Compass(config, 1, magnets).sample(pose, {}, 0).heading;
    EXPECT_NEAR(angle_difference(heading, pose.theta), -turned, 1e-12);
    EXPECT_GT(std::abs(turned), 0.01);
  }
}

}  // namespace
}  // namespace cogslam
