#include "eval/sweep/sweep_file.hpp"

#include <algorithm>

#include "core/text_file.hpp"
#include "eval/sweep/resolved_text.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMaxFileBytes = 1'000'000;
constexpr double kMostSeeds = 100'000;
constexpr const char* kTruePosesSuffix = "_true_poses";

std::vector<std::uint32_t> read_seeds(ConfigSection section) {
  std::uint32_t first = 1, count = 10;
  section.read("first", first);
  section.read("count", count, {1.0, kMostSeeds});
  std::vector<std::uint32_t> seeds;
  for (std::uint32_t i = 0; i < count; ++i) seeds.push_back(first + i);
  return seeds;
}

std::vector<double> read_cell_sizes(ConfigSection& file) {
  std::vector<double> sizes{0.1};
  file.read("cell_sizes_m", sizes, {0.005, 100.0});
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  if (sizes.empty() || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    file.fail("cell_sizes_m", "cell_sizes_m: expected at least one cell size, and each once");
  }
  return sizes;
}

Overrides read_settings(ConfigSection& section) {
  Overrides settings;
  for (ConfigSection& entry : section.sections("set")) {
    std::string key, value;
    entry.read("key", key);
    entry.read("value", value);
    if (key.empty() || value.empty()) entry.fail("key", "set: expected `{key: ..., value: ...}`");
    settings.emplace_back(key, value);
  }
  return settings;
}

/// A relative file of a map means one thing beside its scenario and another in a copy: state it in full.
void state_map_in_full(ConfigSection& scenario) {
  ConfigSection world = scenario.section("world");
  if (!world.has("map")) return;
  std::filesystem::path map;
  world.read("map", map);
  scenario.override_value("world.map", "\"" + std::filesystem::absolute(map).lexically_normal().string() + "\"");
}

SweepWorld read_world_at(const std::filesystem::path& file, const Overrides& settings, const AxisPoint& point) {
  ConfigSection section = ConfigSection::load(file);
  for (const auto& [key, text] : settings) section.override_value(key, text);
  for (const auto& [key, text] : point.settings) section.override_value(key, text);
  state_map_in_full(section);
  SweepWorld world{.scenario = read_scenario(std::move(section), file.stem().string())};
  world.name = world.scenario.name + point.suffix;
  return world;
}

SweepVariant resolved_variant(const ConfigSection& section, VariantConfig config) {
  const std::string slam = ResolvedText(section.resolved()).lines("slam");
  const std::string poses = config.true_poses ? "true" : "false";
  std::string lines = "name: \"" + config.name + "\"\ntrue_poses: " + poses + "\n" + slam;
  return {std::move(config), as_list_entry(lines)};
}

template <class Named>
void add_unique(std::vector<Named>& list, Named next, const std::string& name, const ConfigSection& at) {
  for (const Named& other : list) {
    std::string known;
    if constexpr (std::is_same_v<Named, SweepWorld>) {
      known = other.name;
    } else {
      known = other.config.name;
    }
    if (known == name) at.fail("name", "a second one called '" + name + "', expected a name of its own");
  }
  list.push_back(std::move(next));
}

}  // namespace

SweepFile SweepFile::load(const std::filesystem::path& file) {
  SweepFile config;
  config.text_ = read_text_file(file, kMaxFileBytes);
  config.file_ = file.string();
  ConfigSection section = config.parse();
  config.name = file.stem().string();
  read_name(section, config.name);
  config.seeds = read_seeds(section.section("seeds"));
  config.cell_sizes = read_cell_sizes(section);
  section.read("true_poses", config.true_poses);
  for (const char* list : {"worlds", "variants"}) {  // read, and checked for unknown keys, entry by entry
    if (section.has(list)) section.override_value(list, "[]");
    section.sections(list);
  }
  section.finish();
  return config;
}

ConfigSection SweepFile::parse() const { return ConfigSection::parse(text_, file_); }

std::vector<SweepWorld> SweepFile::worlds() const {
  std::vector<SweepWorld> worlds;
  ConfigSection file = parse();
  for (ConfigSection& entry : file.sections("worlds")) {
    std::filesystem::path scenario;
    if (!entry.has("scenario")) entry.fail("scenario", "expected `scenario: FILE`");
    entry.read("scenario", scenario);
    const Overrides settings = read_settings(entry);
    const std::vector<SweepAxis> axes = read_axes(entry);
    entry.finish();
    for (const AxisPoint& point : axis_points(axes)) {
      with_axis_places(axes, [&] {
        SweepWorld world = read_world_at(scenario, settings, point);
        const std::string known_as = world.name;
        add_unique(worlds, std::move(world), known_as, entry);
      });
    }
  }
  if (worlds.empty()) file.fail("worlds", "worlds: expected at least one `- scenario: FILE`");
  return worlds;
}

std::vector<SweepVariant> SweepFile::variants(const SlamConfig& base) const {
  std::vector<SweepVariant> variants;
  const std::size_t count = parse().sections("variants").size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<SweepAxis> axes = read_axes(parse().sections("variants")[i]);
    for (const AxisPoint& point : axis_points(axes)) {
      ConfigSection entry = parse().sections("variants")[i];  // anew: what was read of other values would stay noted
      with_axis_places(axes, [&] {
        for (const auto& [key, text] : point.settings) entry.override_value(key, text);
        VariantConfig config = read_variant(entry, base);
        read_axes(entry);
        entry.finish();
        config.name += point.suffix;
        add_unique(variants, resolved_variant(entry, config), config.name, entry);
        if (!true_poses || config.true_poses) return;
        config.true_poses = true;
        config.name += kTruePosesSuffix;
        add_unique(variants, resolved_variant(entry, config), config.name, entry);
      });
    }
  }
  if (variants.empty()) parse().fail("variants", "variants: expected at least one");
  return variants;
}

}  // namespace cogslam
