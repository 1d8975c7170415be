#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cogslam {

/// A field to be sensed: 0 free, 1 occupied, and what lies between.
struct FieldMap {
  std::string name;  ///< the file's, without folder and ending
  int width = 0, height = 0;
  std::vector<double> cells;  ///< row-major, the first row of the file first
};

/// What read_field_map reads, for those who ask for a file.
inline constexpr const char* kFieldMapFiles =
    "numbers from 0 (free) to 1 (occupied), .csv or .npy; or a map of the ROS map_server, .yaml, or its picture alone, "
    ".pgm or .png";

/// Out of
/// - a NumPy file (.npy);
/// - a ROS map (.yaml, worlds/map_file.hpp): occupied cells 1, free ones 0, unknown ones 0.5;
/// - a picture (.pgm as P2 or P5, .png): the same, by the thresholds that a ROS map has by default;
/// - numbers separated by commas, a line per row (any other ending).
///
/// Throws InputError, with the place, for a file that cannot be read or holds no cells, rows of different lengths, or a
/// value outside [0, 1].
FieldMap read_field_map(const std::filesystem::path& file);

/// The hallway of worlds/hallway.hpp in 154 rows of 249 cells of 0.25 m, the upper row first: walls 1, what cannot be
/// reached 0.5, all else 0.
FieldMap hallway_field();

}  // namespace cogslam
