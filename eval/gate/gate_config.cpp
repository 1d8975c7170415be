#include "eval/gate/gate_config.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "eval/gate/gate_metric.hpp"

namespace cogslam {
namespace {

bool is_file_name(const std::string& name) {
  return !name.empty() && name.front() != '.' && name.size() <= 100 &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.'; });
}

void read_percent(ConfigSection& section, const std::string& key, double& value, Range range) {
  double percent = 100.0 * value;
  section.read(key, percent, range);
  value = percent / 100.0;
}

GateDemand read_demand(ConfigSection section) {
  GateDemand demand;
  section.read("name", demand.metric);
  const std::vector<std::string> known = gate_metrics();
  if (std::find(known.begin(), known.end(), demand.metric) == known.end()) {
    const std::string near = nearest_name(demand.metric, known);
    section.fail("name", fmt::format("name: unknown metric '{}'; {}", demand.metric,
                                     near.empty() ? fmt::format("expected one of {}", fmt::join(known, ", "))
                                                  : "did you mean '" + near + "'?"));
  }
  section.read_choice("poses", demand.poses,
                      {{"any", GatePoses::kAny}, {"estimated", GatePoses::kEstimated}, {"true", GatePoses::kTrue}});
  read_percent(section, "tolerance_percent", demand.tolerance, {0.0, 1000.0});
  read_percent(section, "effect_percent", demand.effect, {0.1, 1000.0});
  if (demand.effect <= demand.tolerance) {
    section.fail("effect_percent", "effect_percent: expected more than tolerance_percent, which passes");
  }
  return demand;
}

GateScenario read_gate_scenario(ConfigSection section) {
  GateScenario scenario;
  section.read("file", scenario.file);
  if (scenario.file.empty()) section.fail("file", "file: expected the name of a scenario file, found nothing");
  scenario.name = scenario.file.stem().string();
  section.read("name", scenario.name);
  if (!is_file_name(scenario.name)) {
    section.fail("name",
                 "name: expected letters, digits, '_', '-' and '.', at most 100, found '" + scenario.name + "'");
  }
  for (ConfigSection& setting : section.sections("set")) {
    std::string key, value;
    setting.read("key", key);
    setting.read("value", value);
    if (key.empty()) setting.fail("key", "key: expected a key of the scenario, as in {key: duration_s, value: 30}");
    scenario.settings.emplace_back(key, value);
  }
  for (ConfigSection& variant : section.sections("variants")) {
    variant.read("name", scenario.variants.emplace_back());
  }
  return scenario;
}

/// What a gate holds where its file does not say: the path as far as some ten seeds tell, map and memory closely.
std::vector<GateDemand> usual_demands() {
  return {{.metric = "path_mse_m2", .poses = GatePoses::kEstimated, .tolerance = 0.02, .effect = 0.25},
          {.metric = "grid_mse", .poses = GatePoses::kTrue, .tolerance = 0.01, .effect = 0.05},
          {.metric = "bytes", .poses = GatePoses::kAny, .tolerance = 0.01, .effect = 0.05}};
}

}  // namespace

GateConfig read_gate_config(ConfigSection file) {
  GateConfig config;
  file.read("baselines", config.baselines);
  file.read("seeds", config.seeds, {2, 10000});
  file.read("baseline_seeds", config.baseline_seeds, {2, 10000});
  file.read("false_alarm", config.false_alarm, {1e-6, 0.2});
  file.read("power", config.power, {0.5, 0.99});
  for (ConfigSection& section : file.sections("scenarios")) {
    GateScenario scenario = read_gate_scenario(section);
    const auto same = [&](const GateScenario& other) { return other.name == scenario.name; };
    if (std::any_of(config.scenarios.begin(), config.scenarios.end(), same)) {
      section.fail("name", "a second scenario called '" + scenario.name + "', expected a name of its own");
    }
    config.scenarios.push_back(std::move(scenario));
  }
  if (config.scenarios.empty()) {
    file.fail("scenarios", "scenarios: expected at least one, as in - {file: ../simple.yaml}");
  }
  for (const ConfigSection& section : file.sections("metrics")) config.demands.push_back(read_demand(section));
  if (config.demands.empty()) config.demands = usual_demands();
  file.finish();
  return config;
}

GateConfig load_gate_config(const std::filesystem::path& file) {
  GateConfig config = read_gate_config(ConfigSection::load(file));
  // A default is no path of the file, so nobody has put it beside the file yet.
  if (config.baselines == GateConfig{}.baselines) config.baselines = file.parent_path() / config.baselines;
  return config;
}

Scenario load_gate_scenario(const GateScenario& gate, const Overrides& more) {
  Overrides overrides = gate.settings;
  overrides.insert(overrides.end(), more.begin(), more.end());
  Scenario scenario = load_scenario(gate.file, overrides);
  if (gate.variants.empty()) return scenario;
  std::vector<VariantConfig> chosen;
  for (const VariantConfig& variant : scenario.variants) {
    if (std::find(gate.variants.begin(), gate.variants.end(), variant.name) != gate.variants.end()) {
      chosen.push_back(variant);
    }
  }
  for (const std::string& name : gate.variants) {
    const auto called_so = [&](const VariantConfig& variant) { return variant.name == name; };
    if (std::none_of(chosen.begin(), chosen.end(), called_so)) {
      throw InputError({gate.file.string()}, "no variant '" + name + "', which the gate file names");
    }
  }
  scenario.variants = std::move(chosen);
  return scenario;
}

std::filesystem::path baseline_file(const GateConfig& config, const GateScenario& scenario) {
  return config.baselines / (scenario.name + ".yaml");
}

bool applies(const GateDemand& demand, const VariantConfig& variant) {
  if (variant.true_poses && gate_metric_is_of_path(demand.metric)) return false;
  switch (demand.poses) {
    case GatePoses::kAny:
      return true;
    case GatePoses::kEstimated:
      return !variant.true_poses;
    case GatePoses::kTrue:
      return variant.true_poses;
  }
  return false;
}

}  // namespace cogslam
