#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/grid.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"
#include "worlds/occupancy_map.hpp"

// Paths and maps in the formats of others. `*_text` and `*_bytes` make the content; `write_*` write it, whole or not
// at all (core/output_file.hpp), and throw InputError where they cannot.

namespace cogslam {

/// TUM trajectory: one line `stamp x y z qx qy qz qw` per pose [s, m], z = 0. One stamp per pose.
///
/// Lines keep the order of the records: a stamp that jumps backwards stays where it is, since sorting would tear the
/// path apart; evo pairs lines by stamp in any order. Stamps are unique, as read into a double: of several poses with
/// the same stamp the first is kept, the one that `relation_errors` finds as well.
std::string tum_text(std::span<const Time> stamps, std::span<const Pose2> path);
void write_trajectory(const std::filesystem::path& file, std::span<const Time> stamps, std::span<const Pose2> path);

/// What a map of log-odds says of each cell, by `classify`, as worlds/map_file.hpp writes it for ROS.
OccupancyMap ternary_map(const Grid<float>& log_odds);

/// Every bit of the log-odds as a NumPy 1.0 file: little-endian float32, C order, shape (height, width). The first row
/// is the bottom row of the map, as in memory: value [y, x] belongs to the cell whose lower-left corner is
/// origin + resolution (x, y) of the YAML file.
std::string map_npy_bytes(const Grid<float>& log_odds);

/// Writes `<stem>.pgm`, `<stem>.yaml` and `<stem>.npy`; the stem may hold folders and dots.
void write_map(const std::filesystem::path& stem, const Grid<float>& log_odds);

}  // namespace cogslam
