#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/figures.hpp"
#include "cli/interrupt.hpp"
#include "core/config.hpp"
#include "core/error.hpp"

namespace cogslam {
namespace {

constexpr const char* kNoOutput = "standard output cannot be written";

int complain(int code, const char* what) {
  std::fflush(stdout);
  std::fputs(fmt::format("cogslam: {}\n", what).c_str(), stderr);  // where that is full too, no exception
  return code;
}

int run_parsed(const std::vector<Command>& commands) {
  for (const Command& command : commands) {
    if (!command.parser->parsed()) continue;
    const int code = command.run();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return complain(kRunFailed, kNoOutput);
    return code;
  }
  return kUsageError;
}

/// The parser would only say that a subcommand is required. `words`: what follows the name of `parser`.
void reject_unknown_command(const CLI::App& parser, std::span<char* const> words) {
  if (words.empty()) return;
  const std::string word = words.front();
  if (word.starts_with('-')) return;
  std::vector<std::string> names;
  for (const CLI::App* command : parser.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return reject_unknown_command(*command, words.subspan(1));
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  if (names.empty()) return;
  const std::string near = nearest_name(word, names);
  throw InputError("unknown command '" + word + "'" +
                   (near.empty() ? ", expected one of " + fmt::format("{}", fmt::join(names, ", "))
                                 : "; did you mean '" + near + "'?"));
}

int main_program(int argc, char** argv) {
  CLI::App program("FastSLAM with compressed occupancy grids: simulate, record, replay and score.", "cogslam");
  program.require_subcommand(1);
  program.set_version_flag("--version", "cogslam " COGSLAM_VERSION);
  program.footer(
      "Exit codes: 0 ok, 1 gate failed, 2 usage or scenario error, 3 a run failed, 4 nothing measured, "
      "130 interrupted.\nData go to standard output, messages to standard error.");
  const std::vector<Command> commands{
      run_command(program),     replay_command(program),       validate_command(program), gate_command(program),
      lab_command(program),     sense_command(program),        world_command(program),    sweep_command(program),
      figures_command(program), sweep_worker_command(program), generate_command(program)};
  try {
    if (argc > 1) reject_unknown_command(program, {argv + 1, static_cast<std::size_t>(argc - 1)});
    program.parse(argc, argv);
    watch_for_interrupts();
    return run_parsed(commands);
  } catch (const CLI::ParseError& error) {
    const int code = program.exit(error);
    if (!std::cout.flush()) return complain(kRunFailed, kNoOutput);
    return code == 0 ? kOk : kUsageError;
  } catch (const InputError& error) {
    return complain(kUsageError, error.what());
  } catch (const Interrupted&) {
    return complain(kInterrupted, "interrupted, nothing written");
  } catch (const std::bad_alloc&) {
    return complain(kRunFailed, "out of memory: use larger cells, a smaller area, fewer particles or fewer threads");
  } catch (const std::exception& error) {
    return complain(kRunFailed, std::ferror(stdout) != 0 ? kNoOutput : error.what());
  }
}

}  // namespace
}  // namespace cogslam

int main(int argc, char** argv) { return cogslam::main_program(argc, argv); }
