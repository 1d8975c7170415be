#include "sim/driver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kPositionGain = 3.0;  // [1/s], near the goal, where a constant deceleration would overshoot
constexpr double kYawGain = 3.0;       // [1/s]
constexpr double kBrakeShare = 0.7;    // of the acceleration: motors follow late
constexpr double kShortLeg = 0.02;     // a leg shorter than this has no direction [m]

/// The speed at which to approach a goal `distance` away so as to stop there.
double approach_speed(double distance, double top_speed, double acceleration, double gain) {
  return std::min({top_speed, gain * distance, std::sqrt(2.0 * kBrakeShare * acceleration * distance)});
}

}  // namespace

Driver::Driver(DriveConfig config) : config_(std::move(config)) {
  for (const ScriptedTwist& part : config_.script) EXPECTS(part.duration.ns > 0);
}

Twist2 Driver::command(const Truth& truth) {
  const bool first = !last_time_;
  const double dt = first ? 0.0 : (truth.time - *last_time_).seconds();
  last_time_ = truth.time;
  if (first) {
    part_start_ = truth.time;
    if (!config_.waypoints.empty()) start_leg(truth.T_map_base);
  }
  const Twist2 twist = config_.kind == DriveKind::kScript ? scripted(truth.time) : towards_waypoint(truth, dt);
  stuck_.watch(truth, twist, dt);
  return twist;
}

Twist2 Driver::scripted(Time time) {
  if (config_.script.empty()) return {};
  const auto part = [&] { return config_.script[static_cast<std::size_t>(legs_done_) % config_.script.size()]; };
  while (time - part_start_ >= part().duration) {
    part_start_ = part_start_ + part().duration;
    ++legs_done_;
  }
  return part().twist;
}

Twist2 Driver::towards_waypoint(const Truth& truth, double dt) {
  if (config_.waypoints.empty()) return {};
  const Pose2& T_map_base = truth.T_map_base;
  if (arrived(T_map_base)) {
    ++legs_done_;
    start_leg(T_map_base);
  }
  const Eigen::Vector2d to_goal = waypoint().p_map - T_map_base.position();
  const double yaw_error = angle_difference(leg_heading_.value_or(T_map_base.theta), T_map_base.theta);
  double speed = approach_speed(to_goal.norm(), config_.speed, config_.acceleration, kPositionGain);
  if (waypoint().mode == LegHeading::kAlong) speed *= std::max(0.0, std::cos(yaw_error));
  double yaw_rate = std::copysign(
      approach_speed(std::abs(yaw_error), config_.yaw_rate, config_.yaw_acceleration, kYawGain), yaw_error);
  if (waypoint().mode == LegHeading::kTurn) yaw_rate = waypoint().turn_rate;

  const Eigen::Vector2d change = speed * to_goal.normalized() - velocity_;
  const double change_limit = config_.acceleration * dt, yaw_limit = config_.yaw_acceleration * dt;
  velocity_ += change * (change.norm() > change_limit ? change_limit / change.norm() : 1.0);
  yaw_rate_ += std::clamp(yaw_rate - yaw_rate_, -yaw_limit, yaw_limit);
  const double c = std::cos(T_map_base.theta), s = std::sin(T_map_base.theta);
  return {c * velocity_.x() + s * velocity_.y(), c * velocity_.y() - s * velocity_.x(), yaw_rate_};
}

const Waypoint& Driver::waypoint() const {
  return config_.waypoints[static_cast<std::size_t>(legs_done_) % config_.waypoints.size()];
}

bool Driver::arrived(const Pose2& T_map_base) const {
  if ((waypoint().p_map - T_map_base.position()).norm() > config_.arrival) return false;
  return waypoint().mode != LegHeading::kFace ||
         std::abs(angle_difference(*leg_heading_, T_map_base.theta)) <= config_.arrival_yaw;
}

void Driver::start_leg(const Pose2& T_map_base) {
  const Eigen::Vector2d leg = waypoint().p_map - T_map_base.position();
  switch (waypoint().mode) {
    case LegHeading::kAlong:
      if (leg.norm() > kShortLeg) leg_heading_ = std::atan2(leg.y(), leg.x());
      break;
    case LegHeading::kFace:
      leg_heading_ = waypoint().heading;
      break;
    case LegHeading::kTurn:
      leg_heading_.reset();
      return;
    case LegHeading::kKeep:
      break;
  }
  // What was held on the leg before is held on, or small errors of arrival would add up.
  if (!leg_heading_) leg_heading_ = T_map_base.theta;
}

}  // namespace cogslam
