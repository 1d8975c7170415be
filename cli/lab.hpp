#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.hpp"

namespace cogslam {

/// Options that all parts of `lab` share.
struct LabOptions {
  int threads = 0;  ///< filled in with all cores
  int seeds = 30;   ///< random compression matrices behind every mean
  bool quiet = false;
};

void add_lab_options(CLI::App& parser, LabOptions& options);

// The parts of `cogslam lab`, one file each.
Command lab_signal_command(CLI::App& lab);
Command lab_map_command(CLI::App& lab);
Command lab_figures_command(CLI::App& lab);

}  // namespace cogslam
