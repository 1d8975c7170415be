#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "eval/gate/gate_measurement.hpp"

namespace cogslam {

inline constexpr int kBaselineSchema = 1;

/// A measurement as the text of a baseline file: strict YAML, the same text for the same measurement, every number as
/// short as reads back exactly. Figures that some seed did not give are left out. docs/gate.md describes the keys.
std::string baseline_text(const GateMeasurement& measurement);

/// Reads it back. Throws InputError with file:line:column where the file is none, is damaged or of another schema.
GateMeasurement read_baseline(const std::string& text, const std::string& name);

/// Nothing where there is no such file.
std::optional<GateMeasurement> load_baseline(const std::filesystem::path& file);

}  // namespace cogslam
