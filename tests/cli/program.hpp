#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace cogslam {

/// What a program left behind.
struct Outcome {
  int code = -1;    ///< exit code; 128 + signal where a signal ended it
  std::string out;  ///< standard output
  std::string err;  ///< standard error
};

/// Runs build/<preset>/cogslam with these arguments and waits for it. `interrupt_at`: as soon as standard error holds
/// this text, it is sent SIGINT.
Outcome run_program(const std::vector<std::string>& arguments, const std::string& interrupt_at = {});

}  // namespace cogslam
