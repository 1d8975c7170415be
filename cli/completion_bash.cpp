#include <fmt/format.h>

#include "cli/generate.hpp"

namespace cogslam {
namespace {

/// The words that follow the program's name, as the script spells a command: "lab map", or nothing.
std::string words_of(const CommandPage& page) {
  const std::size_t space = page.name.find(' ');
  return space == std::string::npos ? "" : page.name.substr(space + 1);
}

/// What may stand where a command is chosen or an option is begun.
std::string names_in(const CommandPage& page) {
  std::vector<std::string> names;
  for (const CommandPage& command : page.commands) names.push_back(command.name.substr(page.name.size() + 1));
  for (const OptionPage& option : page.options) {
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return fmt::format("{}", fmt::join(names, " "));
}

/// How to complete the value of an option: `words:a b c`, `dirs`, `files`, or `none`.
std::string action_of(const OptionPage& option) {
  if (!option.choices.empty()) return fmt::format("words:{}", fmt::join(option.choices, " "));
  if (option.value == "DIR") return "dirs";
  return option.value == "FILE" || option.positional ? "files" : "none";
}

constexpr char kHead[] = R"(# bash completion for cogslam
_cogslam_fill() {
  case $1 in
    words:*) mapfile -t COMPREPLY < <(compgen -W "${1#words:}" -- "$2") ;;
    dirs) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$2") ;;
    files) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$2") ;;
  esac
}

_cogslam() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= names= value= rest=none i
  COMPREPLY=()
  # bash takes --option=value apart at the sign.
  if [[ $current == "=" ]]; then current=; elif [[ $before == "=" ]]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi
)";

constexpr char kTail[] = R"(  if [[ -n $value ]]; then
    _cogslam_fill "$value" "$current"
  elif [[ $current == -* || $rest == none ]]; then
    _cogslam_fill "words:$names" "$current"
  else
    _cogslam_fill "$rest" "$current"
  fi
}

complete -F _cogslam cogslam
)";

/// Follows the words typed so far to the command that they name.
std::string walk_text(const std::vector<const CommandPage*>& pages) {
  std::string out = "  for ((i = 1; i < COMP_CWORD; i++)); do\n    case \"$command ${COMP_WORDS[i]}\" in\n      ";
  for (std::size_t i = 1; i < pages.size(); ++i) {
    const std::string words = words_of(*pages[i]);
    // A command of the first level follows an empty one.
    out += fmt::format("{}\"{}{}\"", i > 1 ? " | " : "", words.find(' ') == std::string::npos ? " " : "", words);
  }
  return out + ") command=${command:+$command }${COMP_WORDS[i]} ;;\n    esac\n  done\n";
}

std::string command_text(const CommandPage& page) {
  std::string out = fmt::format("    \"{}\")\n      names=\"{}\"\n", words_of(page), names_in(page));
  std::string values;
  for (const OptionPage& option : page.options) {
    if (option.positional) {
      out += "      rest=files\n";
    } else if (!option.value.empty()) {
      values += fmt::format("        {}) value=\"{}\" ;;\n", fmt::join(option.names, " | "), action_of(option));
    }
  }
  if (!values.empty()) out += "      case $before in\n" + values + "      esac\n";
  return out + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CommandPage& program) {
  const std::vector<const CommandPage*> pages = all_pages(program);
  std::string out = kHead + walk_text(pages) + "  case $command in\n";
  for (const CommandPage* page : pages) out += command_text(*page);
  return out + "  esac\n" + kTail;
}

// zsh runs the completions of bash.
std::string zsh_completion(const CommandPage& program) {
  return "#compdef cogslam\nautoload -U +X bashcompinit && bashcompinit\n" + bash_completion(program);
}

}  // namespace cogslam
