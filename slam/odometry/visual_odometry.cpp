#include "slam/odometry/visual_odometry.hpp"

#include "core/check.hpp"

namespace cogslam {

VisualOdometry::VisualOdometry(const CameraModel& model, const VisualOdometryConfig& config)
    : model_(model), config_(config), tracker_(config.flow) {}

std::optional<MotionIncrement> VisualOdometry::update(const FloorImage& image) {
  EXPECTS(image.width == model_.width && image.height == model_.height);
  const double dt = (image.stamp - stamp_).seconds();
  stamp_ = image.stamp;
  if (!tracker_.has_reference()) {
    tracker_.start(image);
    return std::nullopt;
  }
  EXPECTS(dt > 0.0);
  const Pose2 T_key_guess = T_key_last_ * Pose2::exp(dt * twist_);
  const std::vector<FlowPair> pairs =
      tracker_.track(image, [&](const Eigen::Vector2d& pixel) { return predicted(pixel, T_key_guess); });
  const std::optional<PlanarFit> found = fit(pairs);
  if (!found) {
    tracker_.rebase({});
    T_key_last_ = Pose2{};
    twist_ = Twist2{};
    frames_since_key_ = 0;
    return std::nullopt;
  }
  const MotionIncrement increment = increment_to(*found);
  const Twist2 motion = increment.T_before_now.log();
  twist_ = (1.0 / dt) * motion;
  T_key_last_ = found->T_before_now;
  keep_key_fresh(pairs, *found);
  return increment;
}

Eigen::Vector2d VisualOdometry::predicted(const Eigen::Vector2d& pixel, const Pose2& T_key_now) const {
  return model_.pixel_of(T_key_now.inverse() * model_.floor_point(pixel));
}

std::optional<PlanarFit> VisualOdometry::fit(const std::vector<FlowPair>& pairs) const {
  const double least_texture = config_.texture_over_noise * texture_of_noise(config_.pixel_noise);
  std::vector<FloorPair> floor_pairs;
  for (const FlowPair& pair : pairs) {
    if (pair.texture < least_texture) continue;
    floor_pairs.push_back({model_.floor_point(pair.before), model_.floor_point(pair.now)});
  }
  const double pixel = model_.metres_per_pixel();
  const std::optional<PlanarFit> found =
      fit_planar_motion(floor_pairs, {.inlier_distance = config_.inlier_distance * pixel,
                                      .loss_scale = 0.3 * pixel,
                                      .min_inliers = config_.min_inliers});
  if (!found || !found->converged) return std::nullopt;
  if (found->inliers < config_.min_inlier_share * static_cast<double>(floor_pairs.size())) return std::nullopt;
  return found;
}

MotionIncrement VisualOdometry::increment_to(const PlanarFit& fit) const {
  MotionIncrement increment;
  increment.T_before_now = T_key_last_.inverse() * fit.T_before_now;
  increment.source = MotionSource::kVisual;
  const Twist2 motion = increment.T_before_now.log();
  const double along = config_.scale_error * config_.scale_error * (motion.x * motion.x + motion.y * motion.y);
  const double turn = config_.scale_error * config_.scale_error * motion.theta * motion.theta;
  increment.covariance = config_.covariance_factor * fit.covariance;
  increment.covariance.diagonal() += Eigen::Vector3d(along, along, turn);
  return increment;
}

void VisualOdometry::keep_key_fresh(const std::vector<FlowPair>& pairs, const PlanarFit& fit) {
  ++frames_since_key_;
  const bool few_left = 2 * fit.inliers < config_.flow.points;
  if (frames_since_key_ < config_.frames_per_key && !few_left) return;
  std::vector<Eigen::Vector2d> points;
  const double reach = config_.inlier_distance;
  for (const FlowPair& pair : pairs) {
    if ((predicted(pair.before, fit.T_before_now) - pair.now).norm() <= reach) points.push_back(pair.now);
  }
  tracker_.rebase(points);
  T_key_last_ = Pose2{};
  frames_since_key_ = 0;
}

}  // namespace cogslam
