#include "cli/command_page.hpp"

#include <algorithm>
#include <cctype>

namespace cogslam {
namespace {

bool is_name(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_';
  });
}

/// The words of "a,b,c" or "a, b, c"; none where one of them is no plain name.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::size_t first = begin < text.size() && text[begin] == ' ' ? begin + 1 : begin;
    names.push_back(text.substr(first, end - first));
    begin = end + 1;
  }
  if (names.size() < 2 || !std::all_of(names.begin(), names.end(), is_name)) return {};
  return names;
}

/// CLI11 writes type and validators as one: "INT:INT in [1 - 9]", "TEXT:{a,b}".
void read_type(const std::string& type, OptionPage& page) {
  page.value = type.substr(0, type.find(':'));
  const std::size_t range = type.find(" in ["), open = type.find(":{"), close = type.find('}');
  if (range != std::string::npos) page.range = type.substr(range + 4);
  if (open != std::string::npos && close != std::string::npos) {
    page.choices = names_in(type.substr(open + 2, close - open - 2));
  }
}

OptionPage option_page(const CLI::Option& option) {
  OptionPage page{.help = option.get_description(), .positional = option.get_positional()};
  page.required = option.get_required();
  for (const std::string& name : option.get_snames()) page.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) page.names.push_back("--" + name);
  if (page.positional) page.names = {option.get_name(true)};
  if (option.get_items_expected_max() == 0) return page;  // a flag
  read_type(option.get_type_name(), page);
  page.usual = option.get_default_str();
  if (page.choices.empty()) page.choices = names_in(page.help);
  // The number of cores is filled in; pages must not depend on the machine that made them.
  if (page.names.back() == "--threads") page.usual = "all cores";
  return page;
}

CommandPage page_of(const CLI::App& app, const std::string& before) {
  CommandPage page{.name = before + app.get_name(), .help = app.get_description(), .footer = app.get_footer()};
  // CLI11 hands the footer of a program down to its commands.
  if (app.get_parent() != nullptr && app.get_parent()->get_footer() == page.footer) page.footer.clear();
  for (const CLI::Option* option : app.get_options()) page.options.push_back(option_page(*option));
  // Arguments come first, as on the command line.
  std::stable_partition(page.options.begin(), page.options.end(), [](const OptionPage& o) { return o.positional; });
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
    page.commands.push_back(page_of(*command, page.name + " "));
  }
  return page;
}

void collect(const CommandPage& page, std::vector<const CommandPage*>& pages) {
  pages.push_back(&page);
  for (const CommandPage& command : page.commands) collect(command, pages);
}

}  // namespace

CommandPage command_page(const CLI::App& program) { return page_of(program, ""); }

std::vector<const CommandPage*> all_pages(const CommandPage& page) {
  std::vector<const CommandPage*> pages;
  collect(page, pages);
  return pages;
}

}  // namespace cogslam
