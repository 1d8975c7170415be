#pragma once

#include "cli/commands.hpp"

namespace cogslam {

/// `cogslam figures`.
Command figures_command(CLI::App& program);

}  // namespace cogslam
