#pragma once

#include <string>

#include "cli/command_page.hpp"

namespace cogslam {

/// The manual page, section 1, in man(7).
std::string man_page(const CommandPage& program, const std::string& version);

// Completion scripts: commands, options, closed lists of values, files and folders.
std::string bash_completion(const CommandPage& program);
std::string zsh_completion(const CommandPage& program);
std::string fish_completion(const CommandPage& program);

}  // namespace cogslam
