#include "slam/odometry/odometry_config.hpp"

namespace cogslam {
namespace {

void read_visual(ConfigSection section, VisualOdometryConfig& visual) {
  section.read("points", visual.flow.points, {10, 10000});
  section.read("window_px", visual.flow.window, {5, 63});
  section.read("levels", visual.flow.levels, {1, 8});
  section.read("frames_per_key", visual.frames_per_key, {1, 100});
  section.read("pixel_noise_grey", visual.pixel_noise, {0.1, 64.0});
  section.read("texture_over_noise", visual.texture_over_noise, {0.0, 1e6});
  section.read("min_inliers", visual.min_inliers, {3, 10000});
  section.read("min_inlier_share", visual.min_inlier_share, {0.0, 1.0});
  section.read("inlier_distance_px", visual.inlier_distance, {0.01, 100.0});
  section.read("covariance_factor", visual.covariance_factor, {0.01, 1e4});
  section.read("scale_error", visual.scale_error, {0.0, 1.0});
  if (visual.min_inliers > visual.flow.points) {
    section.fail("min_inliers", "more inliers asked for than points looked for, expected at most `points`");
  }
}

void read_wheel(ConfigSection section, WheelOdometryConfig& wheel) {
  section.read("noise_m_per_sqrt_m", wheel.noise_per_sqrt_metre, {0.0, 10.0});
  section.read_degrees("turn_noise_deg_per_sqrt_m", wheel.turn_noise_per_sqrt_metre, {0.0, 180.0});
  section.read("turn_noise_rad_per_sqrt_rad", wheel.turn_noise_per_sqrt_radian, {0.0, 10.0});
  section.read("noise_floor", wheel.noise_floor, {1e-9, 1.0});
}

}  // namespace

void read(ConfigSection& section, OdometryConfig& config) {
  section.read_choice("source", config.source,
                      {{"visual", OdometrySource::kVisual}, {"wheel", OdometrySource::kWheel}});
  read_visual(section.section("visual"), config.visual);
  read_wheel(section.section("wheel"), config.wheel);
}

}  // namespace cogslam
