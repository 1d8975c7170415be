#include "eval/sweep/command.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace cogslam {

CommandOutcome run_command(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(words[0] + ": " + std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  const int reason = errno;
  close(ends[1]);
  CommandOutcome outcome;
  std::array<char, 4096> bytes{};
  for (ssize_t count = 0; child > 0 && (count = ::read(ends[0], bytes.data(), bytes.size())) != 0;) {
    if (count < 0 && errno != EINTR) break;
    if (count > 0) outcome.out.append(bytes.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  if (child < 0) throw std::runtime_error(words[0] + ": " + std::strerror(reason));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

}  // namespace cogslam
