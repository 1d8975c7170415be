#pragma once

#include <string>

#include "eval/gate/gate_report.hpp"

namespace cogslam {

/// What a person reads: a line for each figure with its baseline, its present value, the change, what would have been
/// found and the verdict; then what the gate promises.
std::string gate_table(const GateReport& report);

/// The same as one JSON object; docs/gate.md describes the keys.
std::string gate_json(const GateReport& report);

/// The same as JUnit XML: a suite for each scenario, a case for each figure. Failed is <failure>, not measured <error>.
std::string gate_junit(const GateReport& report);

}  // namespace cogslam
