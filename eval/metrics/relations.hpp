#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "core/pose2.hpp"
#include "core/time.hpp"

namespace cogslam {

/// One line of a SLAM-benchmark `.relations` file (Kuemmerle et al. 2009): where the base really was at one moment,
/// seen from where it was at another.
struct Relation {
  Time from{};
  Time to{};
  Pose2 T_from_to{};
};

/// Reads `t1 t2 x y z roll pitch yaw` lines [s, m, rad], plain or .gz. Empty lines and lines that start with '#' are
/// skipped. Throws InputError where a line has not exactly eight finite numbers, or leaves the plane (z, roll or pitch
/// not 0).
std::vector<Relation> read_relations(const std::filesystem::path& file);

/// Mean and standard deviation (over all, not n - 1) of the size of the errors. Without meaning where count is 0.
struct RelationStats {
  std::size_t count = 0;
  double trans_mean = 0.0;  ///< [m]
  double trans_std = 0.0;   ///< [m]
  double rot_mean = 0.0;    ///< [rad]
  double rot_std = 0.0;     ///< [rad]
};

/// The relations error of one path. `local` relations span at most 5 m of odometric travel, `global` ones more.
struct RelationErrors {
  RelationStats local;
  RelationStats global;
  RelationStats all;
  std::size_t unmatched =
      0;  ///< relations with a stamp that no record has: left out above, so say so where it is not 0
};

/// Scores `path` by e = inv(T_from_to) (inv(T_from) T_to), |translation| and |rotation| of e over all relations.
///
/// One stamp, odometry pose O_i and path pose T_i per record of the log, in file order; an ODOM line and the FLASER
/// line that repeats it are one record. `complete_path` fills a path known at registered records only. A relation's
/// stamp names the record of the nearest stamp, at most 0.02 s away; of several with the same stamp the first.
RelationErrors relation_errors(std::span<const Relation> relations, std::span<const Time> stamps,
                               std::span<const Pose2> odometry, std::span<const Pose2> path);

}  // namespace cogslam
