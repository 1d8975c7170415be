#include "core/mecanum_kinematics.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include "core/rng.hpp"

namespace cogslam {
namespace {

Rng draws(std::uint64_t tick) { return Rng({.seed = 5, .purpose = Purpose::kWorld, .tick = tick}); }

MecanumGeometry random_geometry(Rng& rng) {
  return {rng.uniform(0.02, 0.2), rng.uniform(0.05, 0.5), rng.uniform(0.05, 0.5)};
}

/// Slip of each wheel along its roller axis, from first principles: the floor point under the wheel moves with
/// v + omega x p, the rim with r w forward, and only the part along the axis is held.
Eigen::Vector4d roller_slips(const MecanumGeometry& g, const Twist2& v, const WheelSpeeds& w) {
  Eigen::Vector4d slips;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d p(i < 2 ? g.half_length : -g.half_length, i % 2 == 0 ? g.half_width : -g.half_width);
    const Eigen::Vector2d axis = Eigen::Vector2d(p.x() > 0 ? 1.0 : -1.0, p.y() > 0 ? -1.0 : 1.0).normalized();
    const Eigen::Vector2d rim(v.x - v.theta * p.y() - g.wheel_radius * w[i], v.y + v.theta * p.x());
    slips(static_cast<int>(i)) = rim.dot(axis);
  }
  return slips;
}

TEST(MecanumKinematics, ForwardDrivesAllWheelsForward) {
  const MecanumGeometry g{.wheel_radius = 0.05, .half_length = 0.15, .half_width = 0.13};
  EXPECT_EQ(wheel_speeds(g, {0.5, 0.0, 0.0}), (WheelSpeeds{10.0, 10.0, 10.0, 10.0}));
}

TEST(MecanumKinematics, LeftAndCounterClockwiseHaveTheSignsOfXRollers) {
  const MecanumGeometry g{.wheel_radius = 0.05, .half_length = 0.15, .half_width = 0.10};
  EXPECT_EQ(wheel_speeds(g, {0.0, 0.5, 0.0}), (WheelSpeeds{-10.0, 10.0, 10.0, -10.0}));
  EXPECT_EQ(wheel_speeds(g, {0.0, 0.0, 2.0}), (WheelSpeeds{-10.0, 10.0, -10.0, 10.0}));
}

TEST(MecanumKinematics, InverseLeavesNoRollerSlipping) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = draws(i);
    const MecanumGeometry g = random_geometry(rng);
    const Twist2 v{rng.normal(), rng.normal(), rng.normal()};
    EXPECT_NEAR(roller_slips(g, v, wheel_speeds(g, v)).cwiseAbs().maxCoeff(), 0.0, 1e-12) << "case " << i;
  }
}

TEST(MecanumKinematics, ForwardUndoesInverse) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = draws(1000 + i);
    const MecanumGeometry g = random_geometry(rng);
    const Twist2 v{rng.normal(), rng.normal(), rng.normal()};
    const WheelSpeeds speeds = wheel_speeds(g, v);
    const Twist2 back = base_twist(g, speeds);
    EXPECT_NEAR(back.x, v.x, 1e-12);
    EXPECT_NEAR(back.y, v.y, 1e-12);
    EXPECT_NEAR(back.theta, v.theta, 1e-12);
    EXPECT_NEAR(wheel_disagreement(g, speeds), 0.0, 1e-12);
  }
}

TEST(MecanumKinematics, ForwardIsTheLeastSquaresFitOfDisagreeingWheels) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = draws(2000 + i);
    const MecanumGeometry g = random_geometry(rng);
    const WheelSpeeds w{rng.normal(), rng.normal(), rng.normal(), rng.normal()};
    Eigen::Matrix<double, 4, 3> slip_of_twist;
    slip_of_twist << roller_slips(g, {1, 0, 0}, {}), roller_slips(g, {0, 1, 0}, {}), roller_slips(g, {0, 0, 1}, {});
    const Eigen::Vector3d fit = slip_of_twist.colPivHouseholderQr().solve(-roller_slips(g, {}, w));
    const Twist2 v = base_twist(g, w);
    EXPECT_NEAR(v.x, fit.x(), 1e-12);
    EXPECT_NEAR(v.y, fit.y(), 1e-12);
    EXPECT_NEAR(v.theta, fit.z(), 1e-11);
  }
}

TEST(MecanumKinematics, DisagreementIsTheRimSpeedThatNoTwistExplains) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = draws(3000 + i);
    const MecanumGeometry g = random_geometry(rng);
    const WheelSpeeds w{rng.normal(), rng.normal(), rng.normal(), rng.normal()};
    const WheelSpeeds explained = wheel_speeds(g, base_twist(g, w));
    for (std::size_t wheel = 0; wheel < 4; ++wheel) {
      EXPECT_NEAR(g.wheel_radius * std::abs(w[wheel] - explained[wheel]), std::abs(wheel_disagreement(g, w)), 1e-12);
    }
  }
}

}  // namespace
}  // namespace cogslam
