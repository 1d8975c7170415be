#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/scenario.hpp"

namespace cogslam {

/// Which variants a demand speaks of.
enum class GatePoses { kAny, kEstimated, kTrue };

/// How much one metric may worsen, in every variant of every scenario that has it.
struct GateDemand {
  std::string metric;  ///< one of gate_metrics()
  GatePoses poses = GatePoses::kAny;
  double tolerance = 0.02;  ///< ratio less one: a true change up to this passes
  double effect = 0.25;     ///< ratio less one: a true change of this size must be found
};

/// A scenario as the gate runs it.
struct GateScenario {
  std::string name;  ///< of its baseline
  std::filesystem::path file;
  Overrides settings;                 ///< in place of the file's
  std::vector<std::string> variants;  ///< by name; all where empty
};

/// A gate file: what is run, and what it must hold. docs/gate.md describes the keys.
struct GateConfig {
  std::filesystem::path baselines = "baselines";  ///< folder of the baseline files
  int seeds = 20;                                 ///< that the gate runs
  int baseline_seeds = 60;                        ///< that a baseline is made of: 1, 2, ...
  double false_alarm = 0.01;                      ///< of the whole gate, where every change is the tolerance
  double power = 0.8;                             ///< with which each `effect` must be found
  std::vector<GateScenario> scenarios;
  std::vector<GateDemand> demands;
};

/// Throws InputError with file:line:column.
GateConfig load_gate_config(const std::filesystem::path& file);
GateConfig read_gate_config(ConfigSection file);

/// The scenario with its settings and then `more`; only its chosen variants. Throws InputError.
Scenario load_gate_scenario(const GateScenario& scenario, const Overrides& more = {});

/// Where its baseline is kept: `<baselines>/<name>.yaml`.
std::filesystem::path baseline_file(const GateConfig& config, const GateScenario& scenario);

/// Whether a demand applies to a variant: none to the path of one that was told its poses.
bool applies(const GateDemand& demand, const VariantConfig& variant);

}  // namespace cogslam
