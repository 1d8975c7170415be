#include "slam/health/odometry_watch.hpp"

#include <cmath>

namespace cogslam {
namespace {

constexpr double kStretch = 0.1;     // [m] and [rad]
constexpr double kSigmas = 4.0;      // of what odometry says of itself,
constexpr double kLeast = 0.03;      // and so much more [m]
constexpr double kLeastTurn = 0.03;  // [rad]

bool is_long(const Pose2& motion) {
  return std::hypot(motion.x, motion.y) >= kStretch || std::abs(motion.theta) >= kStretch;
}

}  // namespace

void OdometryWatch::see(const MotionIncrement& motion, const Pose2& T_track_base, bool scan, FilterHealth& health) {
  T_start_now_ = T_start_now_ * motion.T_before_now;
  covariance_ = compose_covariance(covariance_, motion.T_before_now, motion.covariance);
  const Pose2 tracked = T_track_start_.inverse() * T_track_base;
  if (!scan || !(is_long(T_start_now_) || is_long(tracked))) return;
  const Pose2 miss = T_start_now_.inverse() * tracked;
  const double way = kSigmas * std::sqrt(covariance_(0, 0) + covariance_(1, 1)) + kLeast;
  const double turn = kSigmas * std::sqrt(covariance_(2, 2)) + kLeastTurn;
  miss_ = std::max(std::hypot(miss.x, miss.y) / way, std::abs(miss.theta) / turn);
  ++health.odometry_checks;
  if (miss_ > 1.0) ++health.odometry_doubted;
  T_track_start_ = T_track_base;
  T_start_now_ = Pose2{};
  covariance_.setZero();
}

}  // namespace cogslam
