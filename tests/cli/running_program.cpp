#include "tests/cli/running_program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include "tests/cli/sweep_files.hpp"

namespace cogslam {
namespace {

[[noreturn]] void become(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  std::vector<char*> argv{const_cast<char*>(COGSLAM_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  dup2(open((folder / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open((folder / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  execv(COGSLAM_PROGRAM, argv.data());
  _exit(127);
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments) : child_(fork()) {
  if (child_ < 0) throw std::runtime_error("cannot fork");
  if (child_ == 0) become(arguments, folder_.path());
}

RunningProgram::~RunningProgram() {
  if (ended()) return;
  send(SIGKILL);
  waitpid(child_, &status_, 0);
}

void RunningProgram::send(int signal) const {
  if (!ended_) kill(child_, signal);
}

bool RunningProgram::ended() {
  ended_ = ended_ || waitpid(child_, &status_, WNOHANG) == child_;
  return ended_;
}

Outcome RunningProgram::wait() {
  if (!ended_) waitpid(child_, &status_, 0);
  ended_ = true;
  Outcome outcome;
  outcome.code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  outcome.out = content_of(folder_.path() / "out");
  outcome.err = content_of(folder_.path() / "err");
  return outcome;
}

}  // namespace cogslam
