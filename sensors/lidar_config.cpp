#include "sensors/lidar_config.hpp"

#include <numbers>

namespace cogslam {
namespace {

enum class Preset { kUtm30lx, kLms200 };

}  // namespace

LidarConfig LidarConfig::lms200() {
  LidarConfig c;
  c.beams = 181;
  c.field_of_view = radians(180.0);
  c.rate_hz = 10.0;  // the mirror makes 75 sweeps a second; a serial line of 38.4 kBd carries about 10 of them
  c.mirror_hz = 75.0;
  c.range_max_m = 8.0;
  c.resolution_m = 0.010;
  c.accuracy_near_m = c.accuracy_far_m = 0.015;
  c.sigma_near_m = c.sigma_far_m = 0.005;
  return c;
}

std::string LidarConfig::check() const {
  if (range_min_m >= range_max_m) return "range_min_m is not below range_max_m, expected range_min_m < range_max_m";
  const double sweep_s = field_of_view / (2.0 * std::numbers::pi * mirror_hz);
  if (sweep_s * rate_hz > 1.0)
    return "a sweep takes longer than 1 / rate_hz, expected a lower rate_hz or a higher mirror_hz";
  return {};
}

LidarConfig read_lidar_config(ConfigSection& section) {
  Preset preset = Preset::kUtm30lx;
  section.read_choice("preset", preset, {{"utm30lx", Preset::kUtm30lx}, {"lms200", Preset::kLms200}});
  LidarConfig c = preset == Preset::kLms200 ? LidarConfig::lms200() : LidarConfig::utm30lx();
  section.read("beams", c.beams, {2, 100000});
  section.read_degrees("field_of_view_deg", c.field_of_view, {1.0, 360.0});
  section.read("rate_hz", c.rate_hz, {0.01, 1000.0});
  section.read("mirror_hz", c.mirror_hz, {0.01, 1000.0});
  section.read("range_min_m", c.range_min_m, {0.0, 1000.0});
  section.read("range_max_m", c.range_max_m, {0.01, 1000.0});
  section.read("resolution_m", c.resolution_m, {0.0, 1.0});
  section.read("near_limit_m", c.near_limit_m, {0.0, 1000.0});
  section.read("accuracy_near_m", c.accuracy_near_m, {0.0, 100.0});
  section.read("accuracy_far_m", c.accuracy_far_m, {0.0, 100.0});
  section.read("sigma_near_m", c.sigma_near_m, {0.0, 100.0});
  section.read("sigma_far_m", c.sigma_far_m, {0.0, 100.0});
  section.read("dropout_probability", c.dropout_probability, {0.0, 1.0});
  Eigen::Vector2d mount = c.T_base_lidar.position();
  section.read("mount_m", mount, {-10.0, 10.0});
  section.read_degrees("mount_yaw_deg", c.T_base_lidar.theta, {-180.0, 180.0});
  c.T_base_lidar = {mount.x(), mount.y(), wrap_angle(c.T_base_lidar.theta)};
  if (const std::string wrong = c.check(); !wrong.empty()) section.fail("", wrong);
  return c;
}

}  // namespace cogslam
