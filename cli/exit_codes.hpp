#pragma once

namespace cogslam {

/// What the program tells the shell.
enum ExitCode : int {
  kOk = 0,
  kGateFailed = 1,       ///< a figure is worse than its baseline allows
  kUsageError = 2,       ///< a wrong option, or an InputError: a file from outside is wrong
  kRunFailed = 3,        ///< anything else that went wrong
  kNothingMeasured = 4,  ///< it ran, but there was no scan to measure anything by
  kInterrupted = 130,    ///< SIGINT or SIGTERM
};

}  // namespace cogslam
