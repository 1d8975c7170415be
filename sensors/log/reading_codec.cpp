#include "sensors/log/reading_codec.hpp"

namespace cogslam {
namespace {

void put_motion(ByteWriter& out, const MotionIncrement& motion) {
  put_pose(out, motion.T_before_now);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out.put(motion.covariance(row, column));
  out.put(motion.source);
}

MotionIncrement take_motion(ByteReader& in) {
  MotionIncrement motion;
  motion.T_before_now = take_pose(in, "the motion");
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) motion.covariance(row, column) = in.take<double>("the covariance");
  motion.source = static_cast<MotionSource>(in.take_below(3, "the motion's source"));
  return motion;
}

void put_scan(ByteWriter& out, const Scan& scan) {
  for (const double v : {scan.angle_first, scan.angle_increment, scan.range_min, scan.range_max}) out.put(v);
  out.put(scan.time_increment.ns);
  put_pose(out, scan.T_base_lidar);
  out.put_count(scan.ranges.size());
  for (const float range : scan.ranges) out.put(range);
}

Scan take_scan(ByteReader& in) {
  Scan scan;
  for (double* v : {&scan.angle_first, &scan.angle_increment, &scan.range_min, &scan.range_max})
    *v = in.take<double>("the scan's geometry");
  scan.time_increment.ns = in.take<std::int64_t>("the scan's time increment");
  scan.T_base_lidar = take_pose(in, "the lidar's mounting");
  scan.ranges.resize(in.take_count(sizeof(float), "the number of ranges"));
  for (float& range : scan.ranges) range = in.take<float>("a range");
  return scan;
}

}  // namespace

void put_pose(ByteWriter& out, const Pose2& pose) {
  for (const double v : {pose.x, pose.y, pose.theta}) out.put(v);
}

Pose2 take_pose(ByteReader& in, const char* what) {
  const double x = in.take<double>(what), y = in.take<double>(what), theta = in.take<double>(what);
  return {x, y, theta};
}

void put_reading(ByteWriter& out, const Reading& reading) {
  out.put(reading.sequence);
  out.put(reading.stamp.ns);
  put_motion(out, reading.motion);
  for (const double v : {reading.twist.x, reading.twist.y, reading.twist.theta}) out.put(v);
  out.put(static_cast<std::uint8_t>(reading.scan.has_value()));
  if (reading.scan) put_scan(out, *reading.scan);
  out.put(static_cast<std::uint8_t>(reading.heading.has_value()));
  if (reading.heading) out.put(*reading.heading);
}

Reading take_reading(ByteReader& in) {
  Reading reading;
  reading.sequence = in.take<std::uint64_t>("the sequence number");
  reading.stamp.ns = in.take<std::int64_t>("the stamp");
  reading.motion = take_motion(in);
  for (double* v : {&reading.twist.x, &reading.twist.y, &reading.twist.theta}) *v = in.take<double>("the twist");
  if (in.take_below(2, "'has a scan'") != 0) reading.scan = take_scan(in);
  if (in.take_below(2, "'has a heading'") != 0) reading.heading = in.take<double>("the heading");
  return reading;
}

}  // namespace cogslam
