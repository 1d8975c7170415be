#pragma once

#include <CLI/CLI.hpp>

#include "cli/commands.hpp"

namespace cogslam {

/// Options that all parts of `sense` share.
struct SenseOptions {
  int threads = 0;  ///< filled in with all cores
  bool quiet = false;
};

void add_sense_options(CLI::App& parser, SenseOptions& options);

// The parts of `cogslam sense`, one file each.
Command sense_recover_command(CLI::App& sense);
Command sense_offsets_command(CLI::App& sense);
Command sense_hallway_command(CLI::App& sense);
Command sense_log_command(CLI::App& sense);
Command sense_figures_command(CLI::App& sense);

}  // namespace cogslam
