#pragma once

#include <string>
#include <vector>

namespace cogslam {

/// What a program said on its standard output, and how it ended.
struct CommandOutcome {
  int code = -1;  ///< exit code; 127 where it could not be started, 128 + signal where a signal ended it
  std::string out;
};

/// Runs a program found along PATH and waits for it. Its standard error is ours.
CommandOutcome run_command(const std::vector<std::string>& words);

}  // namespace cogslam
