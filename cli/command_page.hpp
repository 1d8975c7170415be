#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace cogslam {

/// One option or positional argument of a command, as people and shells need to know it.
struct OptionPage {
  std::vector<std::string> names;    ///< "-j", "--threads"; that of a positional stands alone: "SCENARIO"
  std::string value;                 ///< what follows it: "INT", "FILE", "KEY=VALUE"; empty for a flag
  std::string range;                 ///< "[1 - 1024]", where there is one
  std::vector<std::string> choices;  ///< the only values there are, where it has such a list
  std::string usual;                 ///< default value, where there is one
  std::string help;
  bool positional = false;
  bool required = false;
};

/// A command with its options, read off the definitions that parse the command line: man page and completions are
/// written from it, so they know what the program knows.
struct CommandPage {
  std::string name;  ///< with all that leads to it: "cogslam lab map"
  std::string help;
  std::string footer;
  std::vector<OptionPage> options;
  std::vector<CommandPage> commands;  ///< hidden ones are left out
};

CommandPage command_page(const CLI::App& program);

/// The page and all below it, parents first.
std::vector<const CommandPage*> all_pages(const CommandPage& page);

}  // namespace cogslam
