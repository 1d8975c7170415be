#include "sensors/log/carmen_log.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "sensors/log/carmen_message.hpp"
#include "sensors/log/plausible.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMostRecords = 4'000'000;  // a week at 7 Hz, 1 GB

/// Equality as the benchmark's metric has it (numpy.allclose), so that both number the records alike.
bool close(double a, double b) { return std::abs(a - b) <= 1e-9 + 1e-5 * std::abs(b); }

bool same_record(const CarmenMessage& a, const CarmenMessage& b) {
  const Pose2 &p = a.T_odom_base, &q = b.T_odom_base;
  return std::abs(a.stamp_s - b.stamp_s) < 1e-6 && close(p.x, q.x) && close(p.y, q.y) && close(p.theta, q.theta);
}

/// Turns messages, one after the other, into records.
class LogBuilder {
 public:
  explicit LogBuilder(const CarmenLogConfig& config) : config_(config) {}

  void set_laser_offset(double x) { T_base_lidar_.x = x; }

  void add(const CarmenMessage& message, const SourcePlace& place) {
    if (last_ && same_record(*last_, message)) {
      ++log.merged_lines;
    } else {
      start_record(message, place);
      last_ = message;
    }
    if (!message.laser) return;
    Reading& reading = log.readings.back();
    if (reading.scan) {
      ++log.dropped_scans;
    } else {
      reading.scan = scan_of(*message.laser);
      ++log.scans;
    }
  }

  CarmenLog log;

 private:
  void start_record(const CarmenMessage& message, const SourcePlace& place) {
    if (log.readings.size() == kMostRecords)
      throw InputError(place, "the log is too long, expected at most 4000000 records");
    Reading reading;
    reading.sequence = log.readings.size();
    reading.stamp = message.stamp;
    reading.twist = message.twist;
    reading.motion.source = MotionSource::kLog;
    if (last_) {
      reading.motion.T_before_now = last_->T_odom_base.inverse() * message.T_odom_base;
      if (const double way = reading.motion.T_before_now.position().norm(); way > kLongestMotion) {
        throw InputError(place, "odometry jumps " + number_text(std::round(way)) +
                                    " m since the record before, expected at most 1000 m");
      }
      reading.motion.covariance = config_.odometry_noise.covariance(reading.motion.T_before_now);
    }
    log.readings.push_back(std::move(reading));
    log.odometry.push_back(message.T_odom_base);
  }

  [[nodiscard]] Scan scan_of(const CarmenMessage::Laser& laser) const {
    Scan scan;
    scan.angle_first = laser.angle_first;
    scan.angle_increment = laser.angle_increment;
    scan.range_max = std::min(config_.no_return_m, laser.range_max.value_or(config_.no_return_m));
    scan.T_base_lidar = laser.T_base_lidar.value_or(T_base_lidar_);
    for (const float range : laser.ranges) {
      const bool returned = static_cast<double>(range) < scan.range_max;
      scan.ranges.push_back(!returned ? Scan::kNoReturn : range > 0.0F ? range : Scan::kInvalid);
    }
    return scan;
  }

  const CarmenLogConfig& config_;
  Pose2 T_base_lidar_{};
  std::optional<CarmenMessage> last_;
};

}  // namespace

CarmenLogConfig read_carmen_log_config(ConfigSection& section) {
  CarmenLogConfig c;
  section.read("no_return_m", c.no_return_m, {1e-3, 1e4});
  ConfigSection noise = section.section("odometry_noise");
  c.odometry_noise = read_odometry_noise(noise);
  return c;
}

CarmenLog read_carmen_log(const std::filesystem::path& file, const CarmenLogConfig& config) {
  LineReader in(file);
  LogBuilder builder(config);
  while (in.next()) {
    LineFields fields(in.line(), in.place());
    if (fields.done()) continue;
    const std::string_view kind = fields.word("message");
    if (kind.front() == '#') continue;
    if (kind == "ODOM") {
      builder.add(parse_odom(fields), in.place());
    } else if (kind == "FLASER") {
      builder.add(parse_flaser(fields), in.place());
    } else if (kind == "ROBOTLASER1") {
      builder.add(parse_robotlaser(fields), in.place());
    } else if (kind == "PARAM" && fields.word("parameter") == "robot_frontlaser_offset") {
      const double offset = fields.number("robot_frontlaser_offset");
      if (std::abs(offset) > kFarthestMount) fields.fail("robot_frontlaser_offset: expected at most 100 m");
      builder.set_laser_offset(offset);
    } else if (kind != "PARAM") {
      ++builder.log.ignored_lines;
    }
  }
  if (builder.log.readings.empty())
    throw InputError({file.string()}, "no record, expected a CARMEN log with ODOM, FLASER or ROBOTLASER1 lines");
  return std::move(builder.log);
}

}  // namespace cogslam
