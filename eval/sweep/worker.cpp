#include "eval/sweep/worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>

#include "core/output_file.hpp"
#include "eval/sweep/episode_job.hpp"

namespace cogslam {
namespace {

void write_all(int descriptor, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = write(descriptor, text.data() + at, text.size() - at);
    if (count < 0 && errno != EINTR) return;  // a log that cannot be written stops nothing
    if (count > 0) at += static_cast<std::size_t>(count);
  }
}

/// Standard output and error become the log of this episode, so that it also holds what a crash says.
void begin_log(const SweepFolder& folder, const EpisodeJob& job) {
  const int log = open(folder.episode(job.key, ".log").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
  if (log < 0) return;
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  close(log);
  write_all(
      STDERR_FILENO,
      fmt::format("replay: cogslam replay {} --truth {} --scenario {}\n", folder.readings(job.readings_key).string(),
                  folder.truth(job.readings_key).string(), folder.episode(job.key, ".yaml").string()));
}

std::string do_job(EpisodeRunner& runner, const SweepFolder& folder, const EpisodeJob& job) {
  begin_log(folder, job);
  const auto note = [](const std::string& line) { write_all(STDERR_FILENO, line + "\n"); };
  std::string answer;
  try {
    runner.run(job, note);
    return kJobDone;
  } catch (const InputError& error) {
    answer = std::string(kJobHopeless) + error.what();
  } catch (const std::exception& error) {
    answer = std::string(kJobFailed) + error.what();
  }
  std::replace(answer.begin(), answer.end(), '\n', ' ');
  note(answer);
  return answer;
}

}  // namespace

void serve_jobs(int socket, const SweepFolder& folder) {
  EpisodeRunner runner(folder);
  std::string received;
  std::array<char, 4096> bytes{};
  for (ssize_t count = 0; (count = ::read(socket, bytes.data(), bytes.size())) != 0;) {
    if (count < 0 && errno != EINTR) return;
    if (count > 0) received.append(bytes.data(), static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = received.find('\n')) != std::string::npos; received.erase(0, end + 1)) {
      write_all(socket, do_job(runner, folder, EpisodeJob::parse(received.substr(0, end))) + "\n");
    }
  }
}

int do_listed_jobs(const std::filesystem::path& list, const SweepFolder& folder) {
  EpisodeRunner runner(folder);
  std::ifstream in(list);
  if (!in) throw InputError({list.string()}, "cannot be read");
  int failed = 0;
  for (std::string line; std::getline(in, line);) {
    const EpisodeJob job = EpisodeJob::parse(line);
    if (std::filesystem::exists(folder.episode(job.key, ".json"))) continue;
    const std::string answer = do_job(runner, folder, job);
    if (answer == kJobDone) continue;
    ++failed;
    write_file(folder.episode(job.key, ".error"), answer.substr(answer.find(' ') + 1));
  }
  return failed;
}

}  // namespace cogslam
