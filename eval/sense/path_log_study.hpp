#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/metrics/relations.hpp"
#include "eval/sense/link_counts.hpp"
#include "sensors/log/carmen_log.hpp"
#include "slam/mobile_sensing/offset_chain.hpp"

namespace cogslam {

/// How a real log is corrected.
struct LogPathConfig {
  PartialMapConfig map{.model = {.range_max_m = 8.0}};  ///< sharp walls: blurred ones lose the way on real rooms
  OffsetConfig offset{.outlier = 0.08,
                      .observable_share = 0.05};  ///< odometry is a good prior: stricter than by default
  int samples = 2048;                             ///< cells of each partial map that are measured
  double step_m = 0.5;                            ///< a scan becomes a partial map after so much odometric travel
  double step_turn = radians(10.0);               ///< or so much turn [rad]
  std::uint32_t seed = 1;                         ///< of the sampled cells

  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

/// A corrected log: a pose for every record.
struct LogPath {
  std::vector<Pose2> poses;  ///< from the first record's odometry on
  int maps = 0;
  LinkCounts links;
};

/// Throws InputError where no record carries a scan: "FILE: no laser scan in the log, expected FLASER or ROBOTLASER1
/// lines", and where no partial map overlaps the one before (expect_overlap).
LogPath correct_log(const CarmenLog& log, const std::filesystem::path& file, const LogPathConfig& config);

/// Relations errors of odometry and of the corrected path, as a table.
std::string log_table(const LogPath& path, const RelationErrors& odometry, const RelationErrors& corrected);

}  // namespace cogslam
