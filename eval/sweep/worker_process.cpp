#include "eval/sweep/worker_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace cogslam {
namespace {

/// In the child. A terminal sends its interrupt to all; the parent alone answers it.
[[noreturn]] void become(const char* program, char* const* arguments, int socket, pid_t parent) {
  signal(SIGINT, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it ended before the line above
  dup2(socket, STDIN_FILENO);
  execv(program, arguments);
  _exit(127);
}

}  // namespace

WorkerProcess::WorkerProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::runtime_error(std::string("a worker cannot be started: ") + std::strerror(errno));
  }
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) become(program.c_str(), words.data(), ends[1], parent);
  const int reason = errno;
  close(ends[1]);
  socket_ = ends[0];
  if (child_ > 0) return;
  close(socket_);
  throw std::runtime_error(std::string("a worker cannot be started: ") + std::strerror(reason));
}

WorkerProcess::~WorkerProcess() {
  close(socket_);
  if (child_ <= 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

bool WorkerProcess::send(const std::string& line) {
  std::string rest = line + "\n";
  while (!rest.empty()) {
    const ssize_t count = ::send(socket_, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    rest.erase(0, static_cast<std::size_t>(count));
  }
  return true;
}

bool WorkerProcess::receive() {
  std::array<char, 4096> bytes{};
  const ssize_t count = ::read(socket_, bytes.data(), bytes.size());
  if (count < 0) return errno == EINTR;
  received_.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0;
}

std::optional<std::string> WorkerProcess::next_line() {
  const std::size_t end = received_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = received_.substr(0, end);
  received_.erase(0, end + 1);
  return line;
}

std::string WorkerProcess::farewell() {
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  if (WIFSIGNALED(status)) return "was ended by signal " + std::to_string(WTERMSIG(status));
  return "ended with code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace cogslam
