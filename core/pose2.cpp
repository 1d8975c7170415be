#include "core/pose2.hpp"

#include <cmath>

namespace cogslam {
namespace {

/// sin(t)/t and (1 - cos(t))/t, by their series near zero, where the quotients have no value. 1 - cos(t) is taken as
/// 2 sin(t/2)^2, which keeps its digits.
struct ArcFactors {
  double along;
  double across;
};

ArcFactors arc_factors(double t) {
  if (std::abs(t) < 1e-4) return {1.0 - t * t / 6.0, t / 2.0 - t * t * t / 24.0};
  const double half = std::sin(0.5 * t);
  return {std::sin(t) / t, 2.0 * half * half / t};
}

}  // namespace

Pose2 Pose2::exp(const Twist2& motion) {
  const auto [s, c] = arc_factors(motion.theta);
  return {s * motion.x - c * motion.y, c * motion.x + s * motion.y, wrap_angle(motion.theta)};
}

Twist2 Pose2::log() const {
  const auto [s, c] = arc_factors(theta);
  const double det = s * s + c * c;  // inverse of the 2x2 matrix [s -c; c s]
  return {(s * x + c * y) / det, (s * y - c * x) / det, theta};
}

Pose2 Pose2::inverse() const {
  const double c = std::cos(theta), s = std::sin(theta);
  return {-c * x - s * y, s * x - c * y, wrap_angle(-theta)};
}

Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  const double c = std::cos(T_a_b.theta), s = std::sin(T_a_b.theta);
  return {T_a_b.x + c * T_b_c.x - s * T_b_c.y, T_a_b.y + s * T_b_c.x + c * T_b_c.y,
          wrap_angle(T_a_b.theta + T_b_c.theta)};
}

Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b) {
  const double c = std::cos(T_a_b.theta), s = std::sin(T_a_b.theta);
  return {T_a_b.x + c * p_b.x() - s * p_b.y(), T_a_b.y + s * p_b.x() + c * p_b.y()};
}

Eigen::Matrix3d compose_covariance(const Eigen::Matrix3d& cov_a_b, const Pose2& T_b_c, const Eigen::Matrix3d& cov_b_c) {
  // A small motion before T_b_c, seen in the frame after it: the adjoint of T_b_c^-1.
  const double c = std::cos(T_b_c.theta), s = std::sin(T_b_c.theta);
  Eigen::Matrix3d adjoint;
  adjoint << c, s, s * T_b_c.x - c * T_b_c.y,  //
      -s, c, c * T_b_c.x + s * T_b_c.y,        //
      0.0, 0.0, 1.0;
  return adjoint * cov_a_b * adjoint.transpose() + cov_b_c;
}

Pose2 interpolate(const Pose2& from, const Pose2& to, double w) {
  return from * Pose2::exp(w * (from.inverse() * to).log());
}

}  // namespace cogslam
