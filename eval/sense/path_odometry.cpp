#include "eval/sense/path_odometry.hpp"

#include <cmath>

#include "core/check.hpp"

namespace cogslam {

std::string OdometryErrorConfig::check() const {
  if (!(scale_sigma >= 0.0)) return "scale_sigma: expected 0 or more";
  if (!(drift_least >= 0.0 && drift_most >= drift_least)) return "drift_least, drift_most: expected 0 <= least <= most";
  if (!(wander_sigma >= 0.0)) return "wander_sigma: expected 0 or more";
  if (!(wander_length_m > 0.0)) return "wander_length_m: expected more than 0";
  return "";
}

FaultyOdometry::FaultyOdometry(const OdometryErrorConfig& config, std::uint32_t seed)
    : config_(config), rng_({.seed = seed, .purpose = Purpose::kWheelRoughness}) {
  EXPECTS(config.check().empty());
  scale_ = 1.0 + config_.scale_sigma * rng_.normal();
  drift_ = config_.drift_most > config_.drift_least ? rng_.uniform(config_.drift_least, config_.drift_most)
                                                    : config_.drift_least;
  if (rng_.uniform() < 0.5) drift_ = -drift_;
  wander_ = config_.wander_sigma * rng_.normal();
}

Pose2 FaultyOdometry::measure(const Pose2& T_before_now) {
  const Twist2 motion = T_before_now.log();
  const double way = std::hypot(motion.x, motion.y);
  const double kept = std::exp(-way / config_.wander_length_m);
  const double turn = (1.0 - config_.turn_share_lost) * motion.theta + (drift_ + wander_) * way;
  wander_ = kept * wander_ + config_.wander_sigma * std::sqrt(1.0 - kept * kept) * rng_.normal();
  return Pose2::exp({scale_ * motion.x, scale_ * motion.y, turn});
}

}  // namespace cogslam
