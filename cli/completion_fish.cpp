#include <fmt/format.h>

#include "cli/generate.hpp"

namespace cogslam {
namespace {

std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

/// True where all words of the command were typed and none of the commands below it.
std::string condition(const CommandPage& page, std::size_t skipped) {
  std::string out;
  for (std::size_t begin = skipped; begin < page.name.size();) {
    const std::size_t end = std::min(page.name.find(' ', begin), page.name.size());
    out += (out.empty() ? "" : "; and ") + ("__fish_seen_subcommand_from " + page.name.substr(begin, end - begin));
    begin = end + 1;
  }
  if (!page.commands.empty()) {
    out += out.empty() ? "not __fish_seen_subcommand_from" : "; and not __fish_seen_subcommand_from";
    for (const CommandPage& command : page.commands) out += command.name.substr(page.name.size());
  }
  return "-n " + in_quotes(out);
}

std::string option_text(const OptionPage& option) {
  std::string out;
  for (const std::string& name : option.names) {
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.choices.empty()) {
    out += fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
  } else if (option.value == "DIR") {
    out += " -x -a '(__fish_complete_directories)'";
  } else if (!option.value.empty()) {
    out += option.value == "FILE" ? " -r -F" : " -x";
  }
  return out + " -d " + in_quotes(option.help);
}

}  // namespace

std::string fish_completion(const CommandPage& program) {
  std::string out = "# fish completion for cogslam\n";
  const std::size_t skipped = program.name.size() + 1;
  for (const CommandPage* page : all_pages(program)) {
    const std::string where = "complete -c cogslam " + condition(*page, skipped);
    if (!page->commands.empty()) out += where + " -f\n";
    for (const CommandPage& command : page->commands) {
      out += where + " -a " + command.name.substr(page->name.size() + 1) + " -d " + in_quotes(command.help) + "\n";
    }
    for (const OptionPage& option : page->options) {
      if (!option.positional) out += where + option_text(option) + "\n";
    }
  }
  return out;
}

}  // namespace cogslam
