#include "cli/generate.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"

namespace cogslam {

Command generate_command(CLI::App& program) {
  auto kind = std::make_shared<std::string>();
  CLI::App* parser = program.add_subcommand("generate", "print the manual page or a completion script");
  parser->group("");  // for those who package the program
  parser->add_option("KIND", *kind, "what to print")->required()->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
  return {parser, [kind, &program] {
            const CommandPage page = command_page(program);
            const std::string text = *kind == "man"    ? man_page(page, COGSLAM_VERSION)
                                     : *kind == "bash" ? bash_completion(page)
                                     : *kind == "zsh"  ? zsh_completion(page)
                                                       : fish_completion(page);
            fmt::print("{}", text);
            return static_cast<int>(kOk);
          }};
}

}  // namespace cogslam
