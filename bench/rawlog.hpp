#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/output_file.hpp"
#include "sensors/log/recording.hpp"

namespace cogslam::bench {

/// MRPT's binary form of objects, little-endian: a class name, a version, the members, an end mark.
class RawlogBytes {
 public:
  void begin(std::string_view type, std::uint8_t version) {
    put(static_cast<std::uint8_t>(0x80 | type.size()));
    bytes_.append(type);
    put(version);
  }
  void end() { put(std::uint8_t{0x88}); }
  template <typename T>
  void put(T value) {
    static_assert(std::endian::native == std::endian::little);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Tenths of a microsecond since 1601.
inline std::uint64_t rawlog_stamp(Time time) {
  return static_cast<std::uint64_t>(time.ns / 100 + 116'444'736'000'000'000);
}

/// CActionCollection of one CActionRobotMovement2D: odometry, with the noise model and the constants that MRPT gives an
/// odometry increment of which nothing more is known.
inline void put_motion(RawlogBytes& out, const Pose2& motion, Time stamp) {
  constexpr float kDegree = 0.0174532925F;
  out.begin("CActionCollection", 0);
  out.put(std::uint32_t{1});
  out.begin("CActionRobotMovement2D", 6);
  out.put(std::uint32_t{0});  // by odometry
  out.begin("CPose2D", 1);
  for (const double value : {motion.x, motion.y, motion.theta}) out.put(value);
  out.end();
  out.put(std::uint32_t{0});  // the Gaussian model: a1 to a4, least sigma of position and of heading
  for (const float value : {0.01F, 0.001F / kDegree, kDegree, 0.05F, 0.01F, 0.2F * kDegree}) out.put(value);
  out.put(std::uint32_t{300});  // the other model, not in use
  for (const float value : {0.05F, 4.0F * kDegree, 0.01F, 0.0001F / kDegree, 0.001F, 0.05F * kDegree}) out.put(value);
  out.put(std::uint8_t{0});  // no velocities
  for (const float value : {0.0F, 0.0F}) out.put(value);
  out.put(std::uint8_t{0});  // no encoders
  for (const std::int32_t value : {0, 0}) out.put(value);
  out.put(rawlog_stamp(stamp));
  out.end();
  out.end();
}

/// CPose3D: the position, then the rotation matrix row by row.
inline void put_pose3(RawlogBytes& out, const Pose2& pose) {
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  out.begin("CPose3D", 3);
  for (const double value : {pose.x, pose.y, 0.0, c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0}) out.put(value);
  out.end();
}

/// CSensoryFrame of one CObservation2DRangeScan. MRPT's beams lie evenly to both sides of the sensor's axis, so that is
/// turned to the middle of the sweep.
inline void put_scan(RawlogBytes& out, const Scan& scan, Time stamp) {
  const double aperture = scan.angle_increment * static_cast<double>(scan.ranges.size() - 1);
  out.begin("CSensoryFrame", 2);
  out.put(std::uint32_t{1});
  out.begin("CObservation2DRangeScan", 6);
  out.put(static_cast<float>(aperture));
  out.put(std::uint8_t{1});  // counter-clockwise
  out.put(static_cast<float>(scan.range_max));
  const Pose2& mount = scan.T_base_lidar;
  put_pose3(out, {mount.x, mount.y, mount.theta + scan.angle_first + 0.5 * aperture});
  out.put(static_cast<std::uint32_t>(scan.ranges.size()));
  for (const float range : scan.ranges) out.put(std::isfinite(range) ? range : static_cast<float>(scan.range_max));
  for (const float range : scan.ranges) out.put(static_cast<std::uint8_t>(std::isfinite(range)));
  out.put(0.01F);  // sigma of a range [m], MRPT's default
  out.put(rawlog_stamp(stamp));
  out.put(0.25F * 0.0174532925F);  // width of a beam, MRPT's default
  out.put(std::uint32_t{0});       // no label
  out.put(0.0);                    // no change of pitch
  out.end();
  out.end();
}

/// Writes the scans of a recording, each with the motion since the scan before, as MRPT's rbpf-slam reads them.
/// `carmen2rawlog` is no way: what it writes has no such pairs, and rbpf-slam 2.5.8 ends on it with a memory fault.
inline void write_rawlog(const std::filesystem::path& file, const Recording& recording) {
  RawlogBytes out;
  Pose2 motion;
  for (const Reading& reading : recording.readings) {
    motion = motion * reading.motion.T_before_now;
    if (!reading.scan) continue;
    put_motion(out, motion, reading.stamp);
    put_scan(out, *reading.scan, reading.stamp);
    motion = {};
  }
  write_file(file, out.bytes());
}

}  // namespace cogslam::bench
