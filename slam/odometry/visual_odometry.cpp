#include "slam/odometry/visual_odometry.hpp"

#include <utility>

#include "core/check.hpp"

namespace cogslam {

namespace {

FlowConfig gated(const VisualOdometryConfig& config) {
  FlowConfig flow = config.flow;
  flow.min_texture = config.texture_over_noise * texture_of_noise(config.pixel_noise);
  return flow;
}

}  // namespace

VisualOdometry::VisualOdometry(const CameraModel& model, const VisualOdometryConfig& config)
    : model_(model), config_(config), tracker_(gated(config)) {}

std::optional<MotionIncrement> VisualOdometry::update(const FloorImage& image) {
  EXPECTS(image.width == model_.width && image.height == model_.height);
  const double dt = (image.stamp - stamp_).seconds();
  stamp_ = image.stamp;
  if (!tracker_.has_reference()) {
    tracker_.start(image);
    return std::nullopt;
  }
  EXPECTS(dt > 0.0);
  tracker_.look(image);
  const std::optional<Found> found = find(dt);
  if (!found) {
    tracker_.rebase({});
    T_key_last_ = Pose2{};
    twist_.reset();
    frames_since_key_ = 0;
    return std::nullopt;
  }
  const MotionIncrement increment = increment_to(found->fit);
  twist_ = (1.0 / dt) * increment.T_before_now.log();
  T_key_last_ = found->fit.T_before_now;
  keep_key_fresh(*found);
  return increment;
}

/// First near where the last twist leads; where that is unknown or fails, near the shift of the whole picture.
std::optional<VisualOdometry::Found> VisualOdometry::find(double dt) const {
  if (tracker_.points() < config_.min_inliers) return std::nullopt;
  std::optional<Found> found;
  if (twist_) {
    const Pose2 T_key_guess = T_key_last_ * Pose2::exp(dt * *twist_);
    found = find_near([&](const Eigen::Vector2d& pixel) { return predicted(pixel, T_key_guess); });
  }
  if (!found) {
    const Eigen::Vector2d shift = tracker_.shift();
    found = find_near([&](const Eigen::Vector2d& pixel) -> Eigen::Vector2d { return pixel + shift; });
  }
  return found;
}

std::optional<VisualOdometry::Found> VisualOdometry::find_near(const FlowTracker::Prediction& predicted) const {
  std::vector<FlowPair> pairs = tracker_.track(predicted);
  std::vector<FloorPair> floor_pairs;
  for (const FlowPair& pair : pairs)
    floor_pairs.push_back({model_.floor_point(pair.before), model_.floor_point(pair.now)});
  const double pixel = model_.metres_per_pixel();
  const std::optional<PlanarFit> fit =
      fit_planar_motion(floor_pairs, {.inlier_distance = config_.inlier_distance * pixel,
                                      .loss_scale = 0.3 * pixel,
                                      .min_inliers = config_.min_inliers});
  if (!fit || !fit->converged) return std::nullopt;
  if (fit->inliers < config_.min_inlier_share * static_cast<double>(pairs.size())) return std::nullopt;
  return Found{*fit, std::move(pairs)};
}

Eigen::Vector2d VisualOdometry::predicted(const Eigen::Vector2d& pixel, const Pose2& T_key_now) const {
  return model_.pixel_of(T_key_now.inverse() * model_.floor_point(pixel));
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

/// Takes the latest picture as reference where it is time to, with the points that agree with the motion.
void VisualOdometry::keep_key_fresh(const Found& found) {
  ++frames_since_key_;
  const bool few_left = 2 * found.fit.inliers < config_.flow.points;
  if (frames_since_key_ < config_.frames_per_key && !few_left) return;
  std::vector<Eigen::Vector2d> points;
  for (const FlowPair& pair : found.pairs) {
    const Eigen::Vector2d expected = predicted(pair.before, found.fit.T_before_now);
    if ((expected - pair.now).norm() <= config_.inlier_distance) points.push_back(pair.now);
  }
  tracker_.rebase(points);
  T_key_last_ = Pose2{};
  frames_since_key_ = 0;
}

}  // namespace cogslam
