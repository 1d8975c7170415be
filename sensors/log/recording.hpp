#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sensors/readings.hpp"

namespace cogslam {

/// All that a filter is given, once and for all: replayed through any configuration it is the same to the last bit.
struct Recording {
  std::string source;             ///< where it came from, for people
  Pose2 start{};                  ///< T_map_base at the first reading
  std::vector<Reading> readings;  ///< in order
};

/// Writes the whole file or nothing.
void write_recording(const std::filesystem::path& file, const Recording& recording);

/// Whether the file begins as a recording does; false also where it cannot be read.
bool is_recording(const std::filesystem::path& file);

/// Throws InputError "file: byte N: ..." where the file is no recording, cut off, damaged or of another version.
Recording read_recording(const std::filesystem::path& file);

/// 16 hexadecimal digits over every bit of the readings: two runs that print the same were given the same.
std::string readings_hash(const std::vector<Reading>& readings);

}  // namespace cogslam
