#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cli/generate.hpp"

namespace cogslam {
namespace {

constexpr char kDate[] = "2026-11-22";  // of the last change of what this file says itself

/// Text that roff takes as it stands.
std::string plain(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_line = i == 0 || text[i - 1] == '\n';
    if (begins_line && (text[i] == '.' || text[i] == '\'')) out += "\\&";
    if (text[i] == '\\') {
      out += "\\e";
    } else if (text[i] == '-') {
      out += "\\-";
    } else {
      out += text[i];
    }
  }
  return out;
}

/// The first letter as a capital where a plain word begins with it, and a full stop.
std::string sentence(std::string text) {
  if (text.empty()) return text;
  const std::size_t end = std::min(text.find_first_of(" ,;:."), text.size());
  const bool plain_word = std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end),
                                      [](unsigned char c) { return std::islower(c) != 0; });
  if (plain_word) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.back() == '.' ? text : text + ".";
}

/// Footers are laid out by hand: their lines stay lines.
std::string verbatim(const std::string& text) { return ".nf\n" + plain(text) + "\n.fi\n"; }

std::string names_of(const OptionPage& option) {
  std::string out;
  for (const std::string& name : option.names) {
    const char font = option.positional ? 'I' : 'B';
    out += fmt::format("{}\\f{}{}\\fR", out.empty() ? "" : ", ", font, plain(name));
  }
  return option.positional || option.value.empty() ? out : out + " \\fI" + plain(option.value) + "\\fR";
}

std::string option_text(const OptionPage& option) {
  std::string out = ".TP\n" + names_of(option) + "\n" + plain(sentence(option.help)) + "\n";
  // A help text that is the list itself does not say it twice.
  const std::string choices = fmt::format("{}", fmt::join(option.choices, ", "));
  if (!option.choices.empty() && choices != option.help) out += "One of " + plain(choices) + ".\n";
  if (!option.range.empty()) out += "In " + plain(option.range) + ".\n";
  if (!option.usual.empty()) out += "Default: " + plain(option.usual) + ".\n";
  return out;
}

std::string synopsis(const CommandPage& page) {
  std::string out = ".B " + plain(page.name) + "\n[\\fIOPTIONS\\fR]";
  for (const OptionPage& option : page.options) {
    if (option.positional) out += " \\fI" + plain(option.names[0]) + "\\fR";
  }
  return out + "\n";
}

std::string command_text(const CommandPage& page) {
  std::string out = ".SS " + plain(page.name) + "\n" + plain(sentence(page.help)) + "\n";
  for (const OptionPage& option : page.options) {
    if (option.names.back() != "--help") out += option_text(option);
  }
  return page.footer.empty() ? out : out + ".PP\n" + verbatim(page.footer);
}

constexpr char kEnd[] = R"(.SH EXIT STATUS
.TP
.B 0
All is well.
.TP
.B 1
A figure is worse than its baseline allows.
.TP
.B 2
A wrong option, or a file from outside is wrong: the message names file, line and column.
.TP
.B 3
A run failed.
.TP
.B 4
It ran, but there was nothing to measure anything by.
.TP
.B 130
Interrupted; nothing was written.
.SH EXAMPLES
Run a scenario that comes with the program, and open the folder that it names:
.PP
.RS
cogslam run /usr/share/cogslam/scenarios/cluttered.yaml
.RE
.PP
The same with a coarser map and fewer particles, the scores as JSON:
.PP
.RS
cogslam run /usr/share/cogslam/scenarios/cluttered.yaml \-\-cell\-size 0.2 \-\-particles 30 \-\-json
.RE
.SH FILES
.TP
.I /usr/share/cogslam/scenarios
Scenarios; cluttered.yaml shows every knob there is.
.TP
.I /usr/share/doc/cogslam/docs/scenario.schema.json
JSON schema of a scenario, for editors.
)";

}  // namespace

std::string man_page(const CommandPage& program, const std::string& version) {
  std::string out =
      fmt::format(".TH COGSLAM 1 {} \"cogslam {}\" \"User Commands\"\n.SH NAME\ncogslam \\- {}\n.SH SYNOPSIS\n", kDate,
                  plain(version), plain("testbed for FastSLAM with compressed occupancy grids"));
  const std::vector<const CommandPage*> pages = all_pages(program);
  std::string before;
  for (const CommandPage* page : pages) {
    if (!page->commands.empty()) continue;
    out += before + synopsis(*page);
    before = ".br\n";
  }
  out += ".SH DESCRIPTION\n" + plain(sentence(program.help)) +
         "\nData go to standard output, messages to standard error.\n.SH COMMANDS\n" +
         "Every command knows \\fB\\-h\\fR, \\fB\\-\\-help\\fR.\n";
  for (const CommandPage* page : pages) {
    if (page != pages.front()) out += command_text(*page);
  }
  return out + kEnd;
}

}  // namespace cogslam
