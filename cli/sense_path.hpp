#pragma once

#include <string>

#include "cli/sense.hpp"

namespace cogslam {

/// Throws InputError with what a config's check() found wrong, if anything.
void expect_right(const std::string& wrong);

}  // namespace cogslam
