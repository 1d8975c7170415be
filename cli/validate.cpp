#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/options.hpp"

namespace cogslam {

Command validate_command(CLI::App& program) {
  struct State {
    Options options;
    std::filesystem::path scenario;
  };
  auto state = std::make_shared<State>();
  CLI::App* parser = program.add_subcommand("validate", "check a scenario and print it with every default filled in");
  parser->add_option("SCENARIO", state->scenario, "scenario file (YAML)")->required();
  add_setting_options(*parser, state->options);
  parser->add_flag("--quiet", state->options.quiet, "print nothing where the scenario is right");
  return {parser, [state] {
            const Scenario scenario = load_scenario(state->scenario, overrides_of(state->options, state->scenario));
            if (!state->options.quiet) fmt::print("{}", scenario.resolved);
            return static_cast<int>(kOk);
          }};
}

}  // namespace cogslam
