#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "sensors/log/odometry_noise.hpp"
#include "sensors/readings.hpp"

namespace cogslam {

struct CarmenLogConfig {
  /// Ranges at or beyond this mean "no return" (SICK writes 81.83 or 81.91); a ROBOTLASER1 line may state less.
  double no_return_m = 50.0;
  OdometryNoise odometry_noise{};
};

CarmenLogConfig read_carmen_log_config(ConfigSection& section);

/// A real robot's log as readings: one for each record.
struct CarmenLog {
  std::vector<Reading> readings;  ///< in file order; stamps of real logs jump back
  std::vector<Pose2> odometry;    ///< T_odom_base of each reading, as logged
  std::size_t scans = 0;          ///< readings that carry one
  std::size_t merged_lines = 0;   ///< lines that repeat the record before (usually the FLASER beside its ODOM)
  std::size_t dropped_scans = 0;  ///< scans whose record had one already
  std::size_t ignored_lines = 0;  ///< of other kinds, comments and empty lines left out
};

/// Reads a CARMEN log, plain or .gz: ODOM, FLASER and ROBOTLASER1 lines and PARAM robot_frontlaser_offset; other lines
/// (RLASER, TRUEPOS, SYNC, ...) are counted and skipped.
///
/// A record is a line of odometry. A line whose stamp (within 1e-6 s) and odometry (within 1e-9 m or rad and 1e-5 of
/// its size) equal the record before is no new record: its scan joins that record, so the motion is applied once.
/// A range of zero or less says nothing (Scan::kInvalid). Scans carry no time between beams.
///
/// Throws InputError with file, line and column for a broken line, and for a file without any record.
CarmenLog read_carmen_log(const std::filesystem::path& file, const CarmenLogConfig& config = {});

}  // namespace cogslam
