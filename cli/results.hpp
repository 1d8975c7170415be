#pragma once

#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "eval/run_folder.hpp"

namespace cogslam {

/// Throws InputError where --out names a place that cannot be written to, before hours are spent on a run.
void check_out(const Options& options);

/// Prints what came out on standard output, writes the run's folder, and returns the exit code.
int publish(const RunFiles& files, const Options& options, ProgressLine& progress);

}  // namespace cogslam
