#pragma once

#include <filesystem>

#include "eval/sweep/folder.hpp"

namespace cogslam {

// What a worker answers to a job.
inline constexpr const char* kJobDone = "done";
inline constexpr const char* kJobFailed = "failed ";      ///< and why: this job alone went wrong
inline constexpr const char* kJobHopeless = "hopeless ";  ///< and why: the next would go wrong, too, as on a full disk

/// Does the jobs that come as lines over `socket`, and answers each with a line, until the other end is closed.
/// Standard output and error of each job go to `episodes/<key>.log`.
void serve_jobs(int socket, const SweepFolder& folder);

/// Does the jobs in the lines of a file, those without a result, one after the other; goes on after one that fails,
/// whose reason it writes to `episodes/<key>.error`.
/// Gives the number of those that failed.
int do_listed_jobs(const std::filesystem::path& list, const SweepFolder& folder);

}  // namespace cogslam
