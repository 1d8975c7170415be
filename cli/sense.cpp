#include "cli/sense.hpp"

#include <algorithm>
#include <memory>
#include <thread>
#include <vector>

#include "cli/exit_codes.hpp"

namespace cogslam {

void add_sense_options(CLI::App& parser, SenseOptions& options) {
  options.threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
  parser.add_option("-j,--threads", options.threads, "threads; only times depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  parser.add_flag("--quiet", options.quiet, "no progress and no notes");
}

Command sense_command(CLI::App& program) {
  CLI::App* sense = program.add_subcommand("sense", "compressive mobile sensing: maps from a few sampled cells");
  sense->require_subcommand(1);
  auto parts = std::make_shared<std::vector<Command>>();
  *parts = {sense_recover_command(*sense), sense_offsets_command(*sense), sense_hallway_command(*sense),
            sense_log_command(*sense), sense_figures_command(*sense)};
  return {sense, [parts] {
            for (const Command& part : *parts) {
              if (part.parser->parsed()) return part.run();
            }
            return static_cast<int>(kUsageError);
          }};
}

}  // namespace cogslam
