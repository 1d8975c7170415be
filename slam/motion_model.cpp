#include "slam/motion_model.hpp"

#include <Eigen/Cholesky>

namespace cogslam {

void MotionModel::add(const MotionIncrement& motion) {
  covariance_ = compose_covariance(covariance_, motion.T_before_now, motion.covariance);
  T_last_now_ = T_last_now_ * motion.T_before_now;
}

void MotionModel::restart() {
  T_last_now_ = Pose2{};
  covariance_.setZero();
}

Eigen::Matrix3d MotionModel::covariance() const {
  const double position = config_.least_sigma_position * config_.least_sigma_position;
  const double heading = config_.least_sigma_heading * config_.least_sigma_heading;
  Eigen::Matrix3d covariance = config_.inflation * config_.inflation * covariance_;
  covariance.diagonal() += Eigen::Vector3d(position, position, heading);
  return covariance;
}

Pose2 MotionModel::sample(const Pose2& T_map_last, Rng& rng) const {
  return sample_pose(T_map_last * T_last_now_, covariance(), rng);
}

Pose2 sample_pose(const Pose2& mean, const Eigen::Matrix3d& covariance, Rng& rng) {
  const Eigen::Matrix3d root = covariance.llt().matrixL();
  const double a = rng.normal(), b = rng.normal(), c = rng.normal();
  const Eigen::Vector3d noise = root * Eigen::Vector3d(a, b, c);
  return mean * Pose2::exp({noise.x(), noise.y(), noise.z()});
}

}  // namespace cogslam
