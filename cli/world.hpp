#pragma once

#include <CLI/CLI.hpp>

#include "cli/commands.hpp"

namespace cogslam {

// The parts of `cogslam world`, one file each.
Command world_export_command(CLI::App& world);

}  // namespace cogslam
