#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace cogslam {

/// A subcommand: its options are known to the parser, `run` does it and returns an exit code.
struct Command {
  CLI::App* parser = nullptr;
  std::function<int()> run;
};

// One file each.
Command run_command(CLI::App& program);
Command replay_command(CLI::App& program);
Command validate_command(CLI::App& program);
Command gate_command(CLI::App& program);
Command lab_command(CLI::App& program);
Command sense_command(CLI::App& program);
Command world_command(CLI::App& program);
Command sweep_command(CLI::App& program);
Command sweep_worker_command(CLI::App& program);
Command generate_command(CLI::App& program);

}  // namespace cogslam
