#include "slam/odometry/visual_odometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "core/angle.hpp"
#include "core/rng.hpp"
#include "floor_drive.hpp"

namespace cogslam {
namespace {

struct Errors {
  int frames = 0;
  int without_estimate = 0;
  double worst_position = 0.0;  ///< [m]
  double worst_turn = 0.0;      ///< [rad]
  double nees = 0.0;            ///< mean of e^T C^-1 e
};

/// Pictures under smoothly changing random twists of up to 0.4 m/s and 0.6 rad/s.
Errors drive(const FloorCameraConfig& camera_config, const Floor& floor, const VisualOdometryConfig& config, int frames,
             std::uint32_t seed) {
  FloorCamera camera(camera_config, floor, seed);
  VisualOdometry odometry(camera_config.model, config);
  Rng rng({.seed = seed, .purpose = Purpose::kWorld});
  const double phase_x = rng.uniform(0.0, 6.0), phase_y = rng.uniform(0.0, 6.0), phase_turn = rng.uniform(0.0, 6.0);
  Pose2 T_map_base{rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0), rng.uniform(-3.0, 3.0)};
  Errors errors;
  for (int i = 0; i < frames; ++i) {
    const double t = i / 30.0;
    const Twist2 twist{0.4 * std::sin(t + phase_x), 0.4 * std::sin(1.3 * t + phase_y),
                       0.6 * std::sin(0.7 * t + phase_turn)};
    const Pose2 motion = Pose2::exp(1.0 / 30.0 * twist);
    T_map_base = T_map_base * motion;
    const auto frame = static_cast<std::uint64_t>(i);
    const auto found = odometry.update(camera.capture(frame, frame_stamp(frame), T_map_base, twist));
    if (i == 0) continue;
    ++errors.frames;
    if (!found) {
      ++errors.without_estimate;
      continue;
    }
    EXPECT_EQ(found->source, MotionSource::kVisual);
    const Twist2 e = (found->T_before_now.inverse() * motion).log();
    const Eigen::Vector3d error(e.x, e.y, e.theta);
    errors.worst_position = std::max(errors.worst_position, std::hypot(e.x, e.y));
    errors.worst_turn = std::max(errors.worst_turn, std::abs(e.theta));
    errors.nees += error.dot(found->covariance.ldlt().solve(error)) / (frames - 1);
  }
  return errors;
}

TEST(VisualOdometry, FollowsRandomMotionsOnCleanPictures) {
  VisualOdometryConfig config;
  config.pixel_noise = 0.5;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Errors errors = drive(clean_camera(), {.kind = FloorKind::kCarpet, .seed = seed}, config, 60, seed);
    EXPECT_EQ(errors.without_estimate, 0);
    EXPECT_LT(errors.worst_position, 0.00005);  // 0.05 pixel
    EXPECT_LT(errors.worst_turn, radians(0.02));
  }
}

TEST(VisualOdometry, FollowsRandomMotionsUnderNoiseVignetteAndSteps) {
  FloorCameraConfig camera;
  camera.light.step = 0.25;
  camera.light.step_period = 0.5;
  for (const FloorKind kind : {FloorKind::kCarpet, FloorKind::kConcrete, FloorKind::kTile}) {
    const Errors errors = drive(camera, {.kind = kind}, {}, 90, 5);
    EXPECT_LE(errors.without_estimate, 2) << static_cast<int>(kind);
    EXPECT_LT(errors.worst_position, 0.0003) << static_cast<int>(kind);
    EXPECT_LT(errors.worst_turn, radians(0.15)) << static_cast<int>(kind);
  }
}

TEST(VisualOdometry, CovarianceIsHonest) {
  // Mean 3 would be exact. The factor on the covariance makes it smaller on purpose: neighbouring windows share pixels,
  // and over a metre the errors add up to more than independent ones would (docs/odometry.md).
  for (const FloorKind kind : {FloorKind::kCarpet, FloorKind::kConcrete, FloorKind::kTile}) {
    const Errors errors = drive(FloorCameraConfig{}, {.kind = kind, .seed = 2}, {}, 150, 7);
    EXPECT_GT(errors.nees, 0.7) << static_cast<int>(kind);
    EXPECT_LT(errors.nees, 3.6) << static_cast<int>(kind);
  }
}

TEST(VisualOdometry, SaysNothingOnAPlainFloor) {
  for (const double vignette : {0.0, 0.4}) {
    FloorCameraConfig camera;
    camera.light.vignette = vignette;
    const Errors errors = drive(camera, {.kind = FloorKind::kPlain}, {}, 30, 3);
    EXPECT_EQ(errors.without_estimate, errors.frames);
  }
  const Errors faint = drive(FloorCameraConfig{}, {.kind = FloorKind::kConcrete, .contrast = 0.1}, {}, 30, 3);
  EXPECT_EQ(faint.without_estimate, faint.frames);
}

TEST(VisualOdometry, WouldBeWrongOnAPlainFloorWithoutItsGate) {
  VisualOdometryConfig open;
  open.texture_over_noise = 0.0;
  open.min_inlier_share = 0.0;
  open.min_inliers = 3;
  const Errors errors = drive(FloorCameraConfig{}, {.kind = FloorKind::kPlain}, open, 30, 3);
  EXPECT_LT(errors.without_estimate, errors.frames);
  EXPECT_GT(errors.worst_position, 0.003);
}

TEST(VisualOdometry, RecoversAfterABlackout) {
  FloorCameraConfig camera;
  camera.blackouts = {{0.49, 0.61}};  // pictures 15 to 18
  const Errors errors = drive(camera, Floor{}, {}, 60, 4);
  EXPECT_EQ(errors.without_estimate, 5);  // into the dark, three times within it, and out of it
  EXPECT_LT(errors.worst_position, 0.0003);
}

TEST(VisualOdometry, KeyPicturesGiveTheSameMotion) {
  VisualOdometryConfig config;
  config.frames_per_key = 4;
  const Errors errors = drive(FloorCameraConfig{}, Floor{}, config, 60, 6);
  EXPECT_EQ(errors.without_estimate, 0);
  EXPECT_LT(errors.worst_position, 0.0003);
}

}  // namespace
}  // namespace cogslam
