#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/run_record.hpp"

namespace cogslam {

/// Scores that a gate can watch, by their names in scores.json: less is better, and none is ever 0 or below.
std::vector<std::string> gate_metrics();

/// The score of that name, one of `gate_metrics()`; nothing where it was not measured or is not positive and finite.
std::optional<double> gate_score(const Scores& scores, const std::string& metric);

/// Whether it is an error of the path, which a variant that maps from the true poses does not have.
bool gate_metric_is_of_path(const std::string& metric);

}  // namespace cogslam
