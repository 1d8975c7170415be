#pragma once

#include <filesystem>

#include "eval/variant_run.hpp"

namespace cogslam {

/// Writes what others are compared with: the online path and the map. Whole or not at all.
void write_baseline(const std::filesystem::path& file, const VariantRun& run);

/// A run with that path and map, and nothing else. Throws InputError where the file is not such a one, cut off or
/// damaged.
VariantRun read_baseline(const std::filesystem::path& file);

}  // namespace cogslam
