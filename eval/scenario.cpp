#include "eval/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/printable.hpp"
#include "eval/fault_list.hpp"
#include "worlds/polygon.hpp"
#include "worlds/world_config.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kLongestName = 100;
constexpr std::size_t kMostVariants = 1000;

/// The area a map covers in a scenario: the world's bounds and a margin, since readings scatter beyond the walls.
Rectangle map_area(const World& world, double margin) {
  Rectangle area = world.bounds();
  area.min.array() -= margin;
  area.max.array() += margin;
  return area;
}

std::vector<double> read_cell_sizes(ConfigSection& section, double usual) {
  std::vector<double> sizes{usual};
  section.read("cell_sizes_m", sizes, {0.005, 100.0});
  if (sizes.empty()) section.fail("cell_sizes_m", "cell_sizes_m: expected at least one cell size");
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    section.fail("cell_sizes_m", "cell_sizes_m: a cell size stands there twice, expected each once");
  }
  return sizes;
}

void check_slam(const ConfigSection& section, const std::string& key, const SlamConfig& slam) {
  try {
    slam.check();
  } catch (const InputError& error) {
    section.fail(key, error.what());
  }
}

/// The body must not stand in a surface at the start: the physics would throw it out.
void check_room_to_stand(const Scenario& scenario, ConfigSection& file) {
  if (has_room_to_stand(scenario.world, scenario.robot, scenario.world.start)) return;
  file.section("world").fail("start", "start: the robot stands in a wall or a box, expected room for its body of " +
                                          fmt::format("{} x {} m", scenario.robot.length, scenario.robot.width));
}

/// A room of 30 m beams: nothing in it is too far to be trusted.
SlamConfig room_defaults() {
  SlamConfig slam;
  slam.sweep.carve_no_return = false;
  return slam;
}

}  // namespace

void read_name(ConfigSection& section, std::string& name) {
  section.read("name", name);
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
  if (!plain || name.empty() || name.front() == '.' || name.size() > kLongestName) {
    section.fail("name", "name: expected letters, digits, '_', '-' and '.', at most 100, found " + in_quotes(name));
  }
}

VariantConfig read_variant(ConfigSection section, const SlamConfig& base) {
  VariantConfig variant{.name = "variant", .slam = base};
  read_name(section, variant.name);
  section.read("true_poses", variant.true_poses);
  ConfigSection slam = section.section("slam");
  read_slam_config(slam, variant.slam);
  check_slam(section, "slam", variant.slam);
  return variant;
}

std::vector<VariantConfig> read_variants(ConfigSection& file, const SlamConfig& base) {
  ConfigSection section = file.section("slam");
  const std::vector<double> cell_sizes = read_cell_sizes(section, base.cell_size);
  SlamConfig shared = base;
  read_slam_config(section, shared);

  std::vector<VariantConfig> kinds;
  std::vector<ConfigSection> listed = file.sections("variants");
  if (listed.size() > kMostVariants) file.fail("variants", "too many variants, expected at most 1000");
  for (ConfigSection& variant : listed) {
    VariantConfig kind = read_variant(variant, shared);
    const auto same = [&kind](const VariantConfig& other) { return other.name == kind.name; };
    if (std::any_of(kinds.begin(), kinds.end(), same)) {
      variant.fail("name", "a second variant called '" + kind.name + "', expected a name of its own");
    }
    kinds.push_back(std::move(kind));
  }
  if (kinds.empty()) {
    check_slam(section, "store", shared);
    kinds.push_back({.name = "slam", .slam = shared});
  }
  if (kinds.size() * cell_sizes.size() > kMostVariants) {
    section.fail("cell_sizes_m", "too many filters to run, expected at most 1000 (variants times cell sizes)");
  }
  std::vector<VariantConfig> variants;
  for (const double cell_size : cell_sizes) {
    for (VariantConfig variant : kinds) {
      variant.slam.cell_size = cell_size;
      check_slam(section, "cell_sizes_m", variant.slam);
      variants.push_back(std::move(variant));
    }
  }
  return variants;
}

Scenario read_scenario(ConfigSection file, const std::string& default_name) {
  Scenario scenario{.name = default_name};
  read_name(file, scenario.name);
  file.read("seed", scenario.seed);
  double duration_s = scenario.duration.seconds();
  file.read("duration_s", duration_s, {0.1, 1e6});
  scenario.duration = Duration::from_seconds(duration_s);
  ConfigSection world = file.section("world"), robot = file.section("robot"), drive = file.section("drive");
  scenario.world = read_world(world);
  scenario.robot = read_robot_config(robot);
  scenario.drive = read_drive_config(drive);
  ConfigSection sensors = file.section("sensors");
  scenario.sensors = read_sensor_suite_config(sensors);
  ConfigSection camera = sensors.section("camera");
  read(camera, scenario.camera);
  scenario.sensors.camera_rate_hz = scenario.camera.enabled ? scenario.camera.rate : 0.0;
  read_faults(file, scenario);
  ConfigSection odometry = file.section("odometry");
  read(odometry, scenario.odometry);

  check_room_to_stand(scenario, file);

  double margin = 0.3;
  ConfigSection map = file.section("map");
  map.read("margin_m", margin, {0.0, 100.0});
  SlamConfig base = room_defaults();
  base.start = scenario.world.start;
  base.area = map_area(scenario.world, margin);
  scenario.variants = read_variants(file, base);
  scenario.slam = base;
  ConfigSection slam = file.section("slam");
  read_slam_config(slam, scenario.slam);
  file.finish();
  scenario.resolved = file.resolved();
  return scenario;
}

Scenario load_scenario(const std::filesystem::path& file, const Overrides& overrides) {
  ConfigSection section = ConfigSection::load(file);
  for (const auto& [path, text] : overrides) section.override_value(path, text);
  return read_scenario(std::move(section), file.stem().string());
}

}  // namespace cogslam
