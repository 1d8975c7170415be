#include "sensors/log/odometry_noise.hpp"

#include <cmath>

namespace cogslam {
namespace {

double square(double v) { return v * v; }

}  // namespace

Eigen::Matrix3d OdometryNoise::covariance(const Pose2& T_before_now) const {
  const double way = T_before_now.position().norm(), turn = std::abs(T_before_now.theta);
  const double position = square(position_per_m) * way + square(position_per_rad) * turn + square(position_floor_m);
  const double heading = square(heading_per_m) * way + square(heading_per_rad) * turn + square(heading_floor);
  return Eigen::Vector3d(position, position, heading).asDiagonal();
}

OdometryNoise read_odometry_noise(ConfigSection& section) {
  OdometryNoise n;
  section.read("position_per_m", n.position_per_m, {0.0, 10.0});
  section.read("position_per_rad", n.position_per_rad, {0.0, 10.0});
  section.read_degrees("heading_per_m_deg", n.heading_per_m, {0.0, 360.0});
  section.read_degrees("heading_per_rad_deg", n.heading_per_rad, {0.0, 360.0});
  section.read("position_floor_m", n.position_floor_m, {1e-9, 10.0});
  section.read_degrees("heading_floor_deg", n.heading_floor, {1e-9, 180.0});
  return n;
}

}  // namespace cogslam
