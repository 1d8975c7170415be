#pragma once

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "core/rng.hpp"
#include "sensors/readings.hpp"

namespace cogslam {

/// What odometry's covariance leaves out.
struct MotionModelConfig {
  double inflation = 1.5;              ///< odometry's standard deviations times this
  double least_sigma_position = 0.01;  ///< per registered step [m]: what odometry is wrong by in every step alike
  double least_sigma_heading = 0.005;  ///< [rad]
};

/// p(x_k | x_k-1, u_k) of eq. (4): the motion told since the last registered scan, and Gaussian noise after it.
class MotionModel {
 public:
  explicit MotionModel(const MotionModelConfig& config) : config_(config) {}

  /// Adds one reading's motion.
  void add(const MotionIncrement& motion);
  /// Puts a better estimate of the motion since the last registered scan in place of the sum; its spread stays.
  void correct(const Pose2& T_last_now) { T_last_now_ = T_last_now; }
  /// Starts anew at a registered scan.
  void restart();

  [[nodiscard]] const Pose2& T_last_now() const { return T_last_now_; }
  /// Of the small motion that follows T_last_now, inflated: positive definite.
  [[nodiscard]] Eigen::Matrix3d covariance() const;
  /// Draws x_k given x_k-1.
  [[nodiscard]] Pose2 sample(const Pose2& T_map_last, Rng& rng) const;

 private:
  MotionModelConfig config_;
  Pose2 T_last_now_{};
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
};

/// mean * exp(noise), noise ~ N(0, covariance).
Pose2 sample_pose(const Pose2& mean, const Eigen::Matrix3d& covariance, Rng& rng);

}  // namespace cogslam
