#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cogslam {

/// What a program left behind.
struct Outcome {
  int code = -1;               ///< exit code; 128 + signal where a signal ended it
  std::string out;             ///< standard output
  std::string err;             ///< standard error
  double cpu_s = 0.0;          ///< CPU time that it took
  std::int64_t rss_bytes = 0;  ///< most memory that it had in RAM
};

/// Under what conditions the program runs. 0 and empty: none.
struct Conditions {
  std::string interrupt_at{};               ///< as soon as standard error holds this text, it is sent SIGINT
  std::filesystem::path standard_output{};  ///< a file or device in place of `Outcome::out`
  bool as_nobody = false;                   ///< without root's rights; code 126 where that cannot be
  std::int64_t file_bytes = 0;              ///< no file may grow beyond, as on a full disk
  std::int64_t memory_bytes = 0;            ///< of address space; left out under a sanitizer, which takes terabytes
  int cpu_s = 0;                            ///< CPU time after which it is killed
  int wall_s = 0;                           ///< time after which it is killed, also where it only waits
};

/// Runs build/<preset>/cogslam with these arguments and waits for it.
Outcome run_program(const std::vector<std::string>& arguments, const Conditions& conditions = {});

/// Whether the program was built with a sanitizer, as this test was.
bool is_sanitized();

}  // namespace cogslam
