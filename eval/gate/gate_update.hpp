#pragma once

#include <optional>
#include <string>

#include "eval/gate/gate_measurement.hpp"

namespace cogslam {

/// What a new baseline says beside the old one, a line for each figure: geometric means, spread, and the change that
/// the gate's seeds will resolve, so that nobody commits a baseline that cannot hold what is asked. `false_alarm`: of
/// each test. `old` nothing: there was none.
std::string update_table(const std::optional<GateMeasurement>& old, const GateMeasurement& now,
                         const Scenario& scenario, const GateConfig& config, double false_alarm);

}  // namespace cogslam
