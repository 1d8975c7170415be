#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/gate/gate_comparison.hpp"
#include "eval/gate/gate_measurement.hpp"

namespace cogslam {

/// One figure against its baseline.
struct GateRow {
  std::string variant;
  double cell_size = 0.0;  ///< [m]
  std::string metric;
  ChangeLimits limits{};
  Verdict verdict = Verdict::kNotMeasured;
  std::optional<Change> change;  ///< nothing where there was nothing to compare
  std::string reason;            ///< why not measured; empty otherwise
};

/// One scenario against its baseline.
struct GateResult {
  std::string scenario;
  std::string baseline_file;
  std::string problem;             ///< why nothing was compared, and what to do: the gate fails; empty otherwise
  bool paired = false;             ///< the same seeds as the baseline's
  GateSeeds seeds{};               ///< that were run
  std::size_t baseline_seeds = 0;  ///< that it is made of
  std::vector<std::string> notes;  ///< what differs from the baseline's setting
  std::vector<GateRow> rows;

  [[nodiscard]] Verdict verdict() const;
};

struct GateReport {
  std::string gate;  ///< the gate file
  std::string program;
  double false_alarm = 0.0;  ///< of the whole gate
  double power = 0.0;
  std::size_t tests = 0;  ///< that share it
  std::vector<GateResult> results;

  /// Failed where any part failed, else not measured where any was not, else passed.
  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] std::size_t count(Verdict verdict) const;  ///< of rows; a scenario with a problem counts as one
};

/// "pass", "FAIL", "not measured".
std::string name_of(Verdict verdict);

/// How many tests the gate makes: its false alarms are shared out among them.
std::size_t count_tests(const std::vector<Scenario>& scenarios, const std::vector<GateDemand>& demands);

/// Why this baseline cannot serve for that scenario and those seeds, or an empty text. Known before anything is run.
/// `baseline` nothing: there is no file.
std::string why_not_comparable(const std::optional<GateMeasurement>& baseline, const Scenario& scenario,
                               const GateSeeds& seeds, const std::string& file);

/// Compares what was measured: paired by seed where the baseline has the same seeds. `false_alarm`: of each test.
GateResult compare(const GateMeasurement& baseline, const GateMeasurement& now, const Scenario& scenario,
                   const GateConfig& config, double false_alarm);

}  // namespace cogslam
