#include "sensors/floor_camera.hpp"

#include <algorithm>

#include "core/rng.hpp"
#include "sensors/floor_renderer.hpp"
#include "sensors/pixel_noise.hpp"
#include "worlds/floor_texture.hpp"

namespace cogslam {
namespace {

void read_model(ConfigSection& section, CameraModel& model) {
  section.read("width_px", model.width, {16, 4096});
  section.read("height_px", model.height, {16, 4096});
  section.read_degrees("field_of_view_deg", model.field_of_view, {1.0, 150.0});
  section.read("height_above_floor_m", model.height_above_floor, {0.01, 10.0});
  Eigen::Vector2d mount = model.T_base_camera.position();
  section.read("mount_m", mount, {-10.0, 10.0});
  section.read_degrees("mount_yaw_deg", model.T_base_camera.theta, {-180.0, 180.0});
  model.T_base_camera = {mount.x(), mount.y(), wrap_angle(model.T_base_camera.theta)};
}

void read_light(ConfigSection& section, FloorLightConfig& light) {
  section.read("vignette", light.vignette, {0.0, 1.0});
  section.read("light_drift", light.drift, {0.0, 1.0});
  section.read("light_drift_period_s", light.drift_period, {0.01, 1e6});
  section.read("light_step", light.step, {0.0, 1.0});
  section.read("light_step_period_s", light.step_period, {0.01, 1e6});
}

}  // namespace

void read(ConfigSection& section, FloorCameraConfig& config) {
  section.read("enabled", config.enabled);
  read_model(section, config.model);
  section.read("height_error", config.height_error, {-0.5, 0.5});
  section.read_degrees("mount_yaw_error_deg", config.yaw_error, {-45.0, 45.0});
  section.read("rate_hz", config.rate, {0.1, 1000.0});
  section.read("noise_grey", config.noise, {0.0, 64.0});
  section.read("exposure_s", config.exposure, {0.0, 1.0});
  section.read("exposure_steps", config.exposure_steps, {1, 100});
  read_light(section, config.light);
  section.read("blackouts_s", config.blackouts, {0.0, 1e6});
  for (const Eigen::Vector2d& span : config.blackouts) {
    if (span.x() >= span.y()) section.fail("blackouts_s", "a blackout ends before it begins, expected [from, to]");
  }
  if (config.exposure * config.rate > 1.0) {
    section.fail("exposure_s",
                 "the exposure is longer than the time between two pictures, expected at most 1 / rate_hz");
  }
}

CameraModel true_model(const FloorCameraConfig& config) {
  CameraModel model = config.model;
  model.height_above_floor *= 1.0 + config.height_error;
  model.T_base_camera.theta = wrap_angle(model.T_base_camera.theta + config.yaw_error);
  return model;
}

FloorCamera::FloorCamera(const FloorCameraConfig& config, const Floor& floor, std::uint32_t seed)
    : config_(config),
      true_model_(true_model(config)),
      seed_(seed),
      vignette_(vignette_gains(config.light, config.model.width, config.model.height)),
      renderer_(std::make_unique<FloorRenderer>(paint_floor(floor), config.model.width, config.model.height)) {}

FloorCamera::~FloorCamera() = default;

FloorImage FloorCamera::capture(std::uint64_t frame, Time stamp, const Pose2& T_map_base, const Twist2& twist) {
  FloorImage image{.stamp = stamp, .width = config_.model.width, .height = config_.model.height, .grey = {}};
  image.grey.resize(vignette_.size());
  const bool dark = blacked_out(stamp);
  if (!dark) expose(T_map_base, twist, image.grey);
  const double gain = dark ? 0.0 : light_gain(config_.light, seed_, stamp);
  light_and_noise(image.grey, vignette_, gain, config_.noise, {seed_, Purpose::kCameraNoise, 0, frame});
  return image;
}

void FloorCamera::expose(const Pose2& T_map_base, const Twist2& twist, std::vector<std::uint8_t>& grey) {
  if (config_.exposure <= 0.0) return render(T_map_base, grey);
  const int steps = config_.exposure_steps;
  std::vector<std::uint32_t> sums(grey.size(), 0);
  for (int i = 0; i < steps; ++i) {
    const double t = config_.exposure * ((i + 0.5) / steps - 0.5);
    render(T_map_base * Pose2::exp(t * twist), grey);
    for (std::size_t j = 0; j < grey.size(); ++j) sums[j] += grey[j];
  }
  const auto n = static_cast<std::uint32_t>(steps);
  for (std::size_t j = 0; j < grey.size(); ++j) grey[j] = static_cast<std::uint8_t>((sums[j] + n / 2) / n);
}

void FloorCamera::render(const Pose2& T_map_base, std::vector<std::uint8_t>& grey) {
  const double w = true_model_.width, h = true_model_.height;
  const auto seen = [&](double x, double y) { return T_map_base * true_model_.floor_point({x, y}); };
  renderer_->render({seen(0, 0), seen(w, 0), seen(w, h), seen(0, h)}, grey);
}

bool FloorCamera::blacked_out(Time stamp) const {
  return std::any_of(config_.blackouts.begin(), config_.blackouts.end(), [&](const Eigen::Vector2d& span) {
    return stamp.seconds() >= span.x() && stamp.seconds() < span.y();
  });
}

}  // namespace cogslam
