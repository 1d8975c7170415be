#pragma once

#include <Eigen/Core>

#include "core/angle.hpp"

namespace cogslam {

/// A velocity or small motion in the plane: forward, left, counter-clockwise.
/// [m/s, m/s, rad/s] as a velocity, [m, m, rad] as the logarithm of a Pose2.
struct Twist2 {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;

  bool operator==(const Twist2&) const = default;
};

constexpr Twist2 operator*(double s, const Twist2& v) { return {s * v.x, s * v.y, s * v.theta}; }

/// Position [m] and heading [rad] in the plane, and the rigid motion that goes with them.
///
/// `T_a_b` is the pose of frame b seen from frame a. `T_a_b * T_b_c == T_a_c`, and `T_a_b * p_b` is the
/// point p seen from a. Axes follow REP-103: x forward, y left, heading counter-clockwise from +x in (-pi, pi].
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;

  /// The motion reached by following `motion` for one unit of time (exponential map of SE(2)).
  static Pose2 exp(const Twist2& motion);

  /// The constant motion that leads here in one unit of time. `exp(log(T)) == T`.
  [[nodiscard]] Twist2 log() const;
  [[nodiscard]] Pose2 inverse() const;
  [[nodiscard]] Eigen::Vector2d position() const { return {x, y}; }

  bool operator==(const Pose2&) const = default;
};

Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c);
Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b);

/// Covariance [m^2, m rad, rad^2] of T_a_c = T_a_b * T_b_c. Each covariance is of the small motion, in the
/// moving frame, that follows its pose: T = mean * exp(noise).
Eigen::Matrix3d compose_covariance(const Eigen::Matrix3d& cov_a_b, const Pose2& T_b_c, const Eigen::Matrix3d& cov_b_c);

/// The pose a share `w` in [0, 1] of the way from `from` to `to`, along the constant motion between them.
Pose2 interpolate(const Pose2& from, const Pose2& to, double w);

}  // namespace cogslam
