#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cogslam {

/// A program started as a child that takes lines and gives lines, both over its standard input (a socket). It ends with
/// this object, and with this process however that ends.
class WorkerProcess {
 public:
  /// Throws std::runtime_error where it cannot be started.
  WorkerProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// For poll.
  [[nodiscard]] int descriptor() const { return socket_; }
  /// False where the child is gone.
  bool send(const std::string& line);
  /// Takes what there is to read; false where the child is gone.
  bool receive();
  /// The next whole line that was received.
  std::optional<std::string> next_line();
  /// Waits for a child that is gone: "ended with code 3", "was ended by signal 11".
  std::string farewell();

 private:
  pid_t child_ = -1;
  int socket_ = -1;
  std::string received_;
};

}  // namespace cogslam
