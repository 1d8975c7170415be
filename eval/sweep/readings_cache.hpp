#pragma once

#include <string>

#include "eval/recorder.hpp"
#include "eval/sweep/folder.hpp"

namespace cogslam {

/// The readings of a scenario and their truth, with how they came about.
struct CachedReadings {
  Recording recording;
  TruthLog truth;
  std::string note;  ///< "found", or why they were made, and what was odd about it
};

/// Reads the readings called `key`; makes and keeps them where they are not there, or damaged. Two processes that do so
/// at once write the same.
CachedReadings cached_readings(const SweepFolder& folder, const std::string& key, const Scenario& scenario);

/// Whether both files are there; they may yet be damaged.
bool has_readings(const SweepFolder& folder, const std::string& key);

}  // namespace cogslam
