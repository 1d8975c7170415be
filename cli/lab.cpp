#include "cli/lab.hpp"

#include <algorithm>
#include <thread>
#include <vector>

#include "cli/exit_codes.hpp"

namespace cogslam {

void add_lab_options(CLI::App& parser, LabOptions& options) {
  options.threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
  parser.add_option("-j,--threads", options.threads, "threads; only times depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  parser.add_flag("--quiet", options.quiet, "no progress and no notes");
}

Command lab_command(CLI::App& program) {
  CLI::App* lab = program.add_subcommand("lab", "how well, and how fast, a signal or a map comes back from some data");
  lab->require_subcommand(1);
  auto parts = std::make_shared<std::vector<Command>>();
  *parts = {lab_signal_command(*lab), lab_map_command(*lab), lab_figures_command(*lab)};
  return {lab, [parts] {
            for (const Command& part : *parts) {
              if (part.parser->parsed()) return part.run();
            }
            return static_cast<int>(kUsageError);
          }};
}

}  // namespace cogslam
