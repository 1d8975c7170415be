#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/config.hpp"
#include "sensors/floor_camera.hpp"
#include "sensors/sensor_suite.hpp"
#include "sim/disturbance.hpp"
#include "sim/drive_config.hpp"
#include "sim/robot_config.hpp"
#include "slam/odometry/odometry_config.hpp"
#include "slam/slam_config.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// One way to run the filter over the readings.
struct VariantConfig {
  std::string name;
  bool true_poses = false;  ///< map from the true poses: scores the store without the filter's chance
  SlamConfig slam{};
};

/// A scenario file: every stage's section, in the order in which data flows.
struct Scenario {
  std::string name;
  std::uint32_t seed = 1;
  Duration duration = Duration::from_seconds(60.0);
  World world{};
  RobotConfig robot{};
  DriveConfig drive{};
  SensorSuiteConfig sensors{};
  FloorCameraConfig camera{};
  DisturbanceConfig disturbances{};  ///< the other faults stand with what they spoil: `world`, `sensors`, `camera`
  OdometryConfig odometry{};
  SlamConfig slam{};                    ///< what every variant starts from
  std::vector<VariantConfig> variants;  ///< every variant at every cell size; the first dense one is the baseline
  std::string resolved;                 ///< the file with every default filled in
};

/// What the command line may change: `key=value` pairs for ConfigSection::override_value.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Throws InputError with file:line:column for anything that is not right.
Scenario load_scenario(const std::filesystem::path& file, const Overrides& overrides = {});
Scenario read_scenario(ConfigSection file, const std::string& default_name);

/// Reads `name`, something that files can be called by: letters, digits, '_', '-' and '.', at most 100.
void read_name(ConfigSection& section, std::string& name);

/// One entry of `variants:`, over what it starts from; its cell size is that of `base`.
VariantConfig read_variant(ConfigSection section, const SlamConfig& base);

/// Reads `slam:` and `variants:` of a file: each variant starts from the `slam:` section and changes parts of it, and
/// runs at each of `slam.cell_sizes_m`. `base` holds what the caller knows (area, start, defaults of its sensor).
std::vector<VariantConfig> read_variants(ConfigSection& file, const SlamConfig& base);

}  // namespace cogslam
