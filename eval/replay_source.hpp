#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/scenario.hpp"
#include "sensors/log/carmen_log.hpp"
#include "sensors/log/recording.hpp"

namespace cogslam {

/// How a log is read and which filters it is replayed through.
struct ReplayConfig {
  std::uint32_t seed = 1;
  CarmenLogConfig log{};
  std::vector<VariantConfig> variants;  ///< they start at the origin until `start_at`
  std::string resolved;                 ///< with every default filled in
};

/// Defaults for a robot of unknown make: an indoor robot with one laser, driven for minutes to hours. Fewer particles
/// than in the rooms, since the proposal follows the scans; smaller cells; every scan is tracked, and one
/// registered every 0.3 m or 15 deg.
SlamConfig log_defaults();

/// Reads `seed`, `log`, `map.area_m` ([x0, y0, x1, y1], needed by the store `coefficients`), `slam` and `variants`.
/// Throws InputError with its place for anything that is not right.
ReplayConfig read_replay_config(ConfigSection file);

/// Reads an own recording (told by its first bytes) or a CARMEN log, plain or .gz. A CARMEN log starts at the origin,
/// whatever its odometry says of the first record.
Recording load_log(const std::filesystem::path& file, const CarmenLogConfig& config);

/// Lets every variant start where the recording does.
void start_at(const Pose2& T_map_base, std::vector<VariantConfig>& variants);

/// The file's name without folder and without the endings .gz and then one more: "intel" of "data/intel.clf.gz".
std::string log_name(const std::filesystem::path& file);

}  // namespace cogslam
