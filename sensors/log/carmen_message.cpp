#include "sensors/log/carmen_message.hpp"

#include <numbers>

#include "core/number_text.hpp"

namespace cogslam {
namespace {

constexpr int kMaxBeams = 100000;

Pose2 take_pose(LineFields& fields, const std::string& whose) {
  const double x = fields.number(whose + "_x"), y = fields.number(whose + "_y");
  return {x, y, wrap_angle(fields.number(whose + "_theta"))};
}

std::vector<float> take_ranges(LineFields& fields) {
  const auto count = static_cast<std::size_t>(fields.whole_number("num_readings", 2, kMaxBeams));
  std::vector<float> ranges;
  for (std::size_t i = 0; i < count; ++i)
    ranges.push_back(static_cast<float>(fields.number("range[" + std::to_string(i) + "]")));
  return ranges;
}

/// A stamp has more digits than a double: seconds and fraction are read apart.
Time exact_time(std::string_view text, double nearest) {
  const std::size_t point = text.find('.');
  const auto seconds = parse_whole_number(text.substr(0, point));
  if (!seconds) return Time::from_seconds(nearest);
  const double fraction = point == text.npos ? 0.0 : parse_number("0" + std::string(text.substr(point))).value_or(0.0);
  const std::int64_t ns = Duration::from_seconds(fraction).ns;
  return {*seconds * 1'000'000'000 + (text.front() == '-' ? -ns : ns)};
}

void take_stamp(LineFields& fields, CarmenMessage& message) {
  const std::string_view text = fields.word("timestamp");
  const auto stamp = parse_number(text);
  // Nanoseconds in 64 bits reach 292 years.
  if (!stamp || std::abs(*stamp) > 9e9) fields.fail("timestamp: expected seconds, found '" + std::string(text) + "'");
  message.stamp_s = *stamp;
  message.stamp = exact_time(text, *stamp);
  fields.word("host");
  fields.number("logger_timestamp");
}

}  // namespace

CarmenMessage parse_odom(LineFields& fields) {
  CarmenMessage message;
  message.T_odom_base = take_pose(fields, "odom");
  message.twist.x = fields.number("tv");
  message.twist.theta = fields.number("rv");
  fields.number("accel");
  take_stamp(fields, message);
  return message;
}

CarmenMessage parse_flaser(LineFields& fields) {
  CarmenMessage message;
  CarmenMessage::Laser laser;
  laser.ranges = take_ranges(fields);
  const auto count = static_cast<int>(laser.ranges.size());
  laser.angle_first = -0.5 * std::numbers::pi;
  laser.angle_increment = std::numbers::pi / (count % 2 == 1 ? count - 1 : count);
  // Not the mounting: in logs that somebody corrected this is the corrected pose, and odometry stays raw.
  take_pose(fields, "laser");
  message.T_odom_base = take_pose(fields, "odom");
  take_stamp(fields, message);
  message.laser = std::move(laser);
  return message;
}

CarmenMessage parse_robotlaser(LineFields& fields) {
  CarmenMessage message;
  CarmenMessage::Laser laser;
  fields.whole_number("laser_type");
  laser.angle_first = fields.number("start_angle");
  fields.number("field_of_view");
  laser.angle_increment = fields.number("angular_resolution");
  if (laser.angle_increment <= 0.0)
    fields.fail("angular_resolution is not positive, expected radians between two beams");
  if (const double max = fields.number("maximum_range"); max > 0.0) laser.range_max = max;
  fields.number("accuracy");
  fields.whole_number("remission_mode");
  laser.ranges = take_ranges(fields);
  const auto remissions = fields.whole_number("num_remissions", 0, kMaxBeams);
  for (std::int64_t i = 0; i < remissions; ++i) fields.number("remission[" + std::to_string(i) + "]");
  const Pose2 T_odom_lidar = take_pose(fields, "laser");
  message.T_odom_base = take_pose(fields, "robot");
  laser.T_base_lidar = message.T_odom_base.inverse() * T_odom_lidar;
  message.twist.x = fields.number("laser_tv");
  message.twist.theta = fields.number("laser_rv");
  for (const char* name : {"forward_safety_dist", "side_safety_dist", "turn_axis"}) fields.number(name);
  take_stamp(fields, message);
  message.laser = std::move(laser);
  return message;
}

}  // namespace cogslam
