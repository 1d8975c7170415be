#include "slam/loop_drift.hpp"

#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kWide = 0.05;  // m

}  // namespace

void LoopDrift::move(const Pose2& T_last_now) {
  const double travel = std::hypot(T_last_now.x, T_last_now.y);
  ways_.push_back((ways_.empty() ? 0.0F : ways_.back()) + static_cast<float>(travel));
  const double position = config_.drift_position * config_.drift_position * travel;
  const double heading = config_.drift_heading * config_.drift_heading * travel;
  added_ = Eigen::Vector3d(position, position, heading).asDiagonal();
  kept_ = compose_covariance(kept_, T_last_now, Eigen::Matrix3d::Zero());
}

void LoopDrift::look(bool old_map_in_sight) {
  released_.setZero();
  if (old_map_in_sight) {
    released_ = kept_;
    kept_ = config_.known_share * added_;
  } else {
    kept_ += added_;
  }
}

bool LoopDrift::is_old(std::size_t registered) const {
  EXPECTS(registered < ways_.size());
  return ways_.back() - ways_[registered] >= config_.least_way;
}

bool LoopDrift::old_map_in_sight(const Pose2& T_map_base, std::span<const RegisteredPose> path) const {
  for (std::size_t i = 0; i < path.size() && is_old(i); ++i) {
    if ((path[i].T_map_base.position() - T_map_base.position()).norm() < config_.sight) return true;
  }
  return false;
}

bool LoopDrift::closes_loop() const { return std::sqrt(released_(0, 0) + released_(1, 1)) > kWide; }

}  // namespace cogslam
