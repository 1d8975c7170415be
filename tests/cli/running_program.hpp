#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {

/// build/<preset>/cogslam at work, to be looked at and stopped; killed with this object.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  [[nodiscard]] pid_t pid() const { return child_; }
  void send(int signal) const;
  /// Whether it has ended.
  bool ended();
  /// Waits for its end.
  Outcome wait();

 private:
  TemporaryFolder folder_;
  pid_t child_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace cogslam
