#include "tests/cli/program.hpp"

#include <fcntl.h>
#include <grp.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

constexpr int kCannotDrop = 126;
constexpr uid_t kNobody = 65534;

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void limit(int resource, std::int64_t most) {
  if (most <= 0) return;
  const rlimit bound{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &bound);
}

void submit_to(const Conditions& conditions) {
  limit(RLIMIT_CPU, conditions.cpu_s);
  limit(RLIMIT_CORE, 1);
  if (!is_sanitized()) limit(RLIMIT_AS, conditions.memory_bytes);
  if (conditions.file_bytes > 0) {
    signal(SIGXFSZ, SIG_IGN);  // a full disk sends none either
    limit(RLIMIT_FSIZE, conditions.file_bytes);
  }
  if (!conditions.as_nobody || geteuid() != 0) return;
  if (setgroups(0, nullptr) != 0 || setgid(kNobody) != 0 || setuid(kNobody) != 0) _exit(kCannotDrop);
}

[[noreturn]] void become_program(const std::vector<std::string>& arguments, const std::string& out,
                                 const std::string& err, const Conditions& conditions) {
  std::vector<char*> argv{const_cast<char*>(COGSLAM_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  submit_to(conditions);
  execv(COGSLAM_PROGRAM, argv.data());
  _exit(kCannotDrop);
}

/// Waits for the child, and interrupts or kills it where the conditions say so.
int wait_for(pid_t child, const std::string& err, const Conditions& conditions, rusage& used) {
  const auto start = std::chrono::steady_clock::now();
  bool interrupted = conditions.interrupt_at.empty();
  int status = 0;
  while (wait4(child, &status, WNOHANG, &used) == 0) {
    if (!interrupted && content(err).find(conditions.interrupt_at) != std::string::npos) {
      kill(child, SIGINT);
      interrupted = true;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (conditions.wall_s > 0 && passed.count() > conditions.wall_s) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return status;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#elif defined(__clang__)
  return __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
  return false;
#endif
}

Outcome run_program(const std::vector<std::string>& arguments, const Conditions& conditions) {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "out", err = folder.path() / "err";
  const std::string out_file = conditions.standard_output.empty() ? out : conditions.standard_output.string();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become_program(arguments, out_file, err, conditions);
  rusage used{};
  const int status = wait_for(child, err, conditions, used);
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = content(out),
          .err = content(err),
          .cpu_s = seconds(used.ru_utime) + seconds(used.ru_stime),
          .rss_bytes = 1024 * used.ru_maxrss};
}

}  // namespace cogslam
