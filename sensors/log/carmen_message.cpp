#include "sensors/log/carmen_message.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "sensors/log/plausible.hpp"

namespace cogslam {
namespace {

constexpr int kMaxBeams = static_cast<int>(kMostBeams);
constexpr double kWidest = 6.3;       // rad
constexpr double kSaysNothing = 1e6;  // no range of a real scan, and still a float

double take_position(LineFields& fields, const std::string& name) {
  const double position = fields.number(name);
  if (std::abs(position) > kFarthest) fields.fail(name + ": expected at most 1e6 m from the origin");
  return position;
}

Pose2 take_pose(LineFields& fields, const std::string& whose) {
  const double x = take_position(fields, whose + "_x"), y = take_position(fields, whose + "_y");
  return {x, y, wrap_angle(fields.number(whose + "_theta"))};
}

double take_speed(LineFields& fields, const std::string& name) {
  const double speed = fields.number(name);
  if (std::abs(speed) > kFastest) fields.fail(name + ": expected at most 1e6 m/s or rad/s");
  return speed;
}

std::vector<float> take_ranges(LineFields& fields) {
  const auto count = static_cast<std::size_t>(fields.whole_number("num_readings", 2, kMaxBeams));
  std::vector<float> ranges;
  for (std::size_t i = 0; i < count; ++i)
    ranges.push_back(
        static_cast<float>(std::clamp(fields.number("range[" + std::to_string(i) + "]"), -kSaysNothing, kSaysNothing)));
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
  if (!stamp || std::abs(*stamp) > kLatestStamp) fields.fail("timestamp: expected seconds, found " + in_quotes(text));
  message.stamp_s = *stamp;
  message.stamp = exact_time(text, *stamp);
  fields.word("host");
  fields.number("logger_timestamp");
}

}  // namespace

CarmenMessage parse_odom(LineFields& fields) {
  CarmenMessage message;
  message.T_odom_base = take_pose(fields, "odom");
  message.twist.x = take_speed(fields, "tv");
  message.twist.theta = take_speed(fields, "rv");
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
  if (std::abs(laser.angle_first) > kWidest) fields.fail("start_angle: expected radians, at most 2 pi");
  fields.number("field_of_view");
  laser.angle_increment = fields.number("angular_resolution");
  if (!(laser.angle_increment > 0.0 && laser.angle_increment <= kWidest))
    fields.fail("angular_resolution: expected radians between two beams, more than 0 and at most 2 pi");
  if (const double max = fields.number("maximum_range"); max > 0.0) laser.range_max = max;
  fields.number("accuracy");
  fields.whole_number("remission_mode");
  laser.ranges = take_ranges(fields);
  const auto remissions = fields.whole_number("num_remissions", 0, kMaxBeams);
  for (std::int64_t i = 0; i < remissions; ++i) fields.number("remission[" + std::to_string(i) + "]");
  const Pose2 T_odom_lidar = take_pose(fields, "laser");
  message.T_odom_base = take_pose(fields, "robot");
  laser.T_base_lidar = message.T_odom_base.inverse() * T_odom_lidar;
  if (laser.T_base_lidar->position().norm() > kFarthestMount)
    fields.fail("the laser stands more than 100 m from the robot, expected it on the robot");
  message.twist.x = take_speed(fields, "laser_tv");
  message.twist.theta = take_speed(fields, "laser_rv");
  for (const char* name : {"forward_safety_dist", "side_safety_dist", "turn_axis"}) fields.number(name);
  take_stamp(fields, message);
  message.laser = std::move(laser);
  return message;
}

}  // namespace cogslam
