#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/pose2.hpp"
#include "core/time.hpp"
#include "sensors/reference.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Where the base truly was at the stamp of a reading.
struct TruePose {
  std::uint64_t sequence = 0;  ///< of the reading
  Time stamp{};
  Pose2 T_map_base{};

  bool operator==(const TruePose&) const = default;
};

/// The other half of a recording: what only the scoring may know. It lies in a file of its own.
struct TruthLog {
  std::string readings_hash;             ///< of the readings that it belongs to
  World world{};                         ///< start pose included
  std::vector<TruePose> poses;           ///< one per reading, in order
  std::vector<ReferenceFix> references;  ///< in the order of their stamps
};

/// Writes the whole file or nothing.
void write_truth_log(const std::filesystem::path& file, const TruthLog& log);

/// Throws InputError "file: byte N: ..." where the file is no truth log, cut off, damaged or of another version.
TruthLog read_truth_log(const std::filesystem::path& file);

}  // namespace cogslam
