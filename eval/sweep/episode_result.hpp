#pragma once

#include <string>

#include "eval/run_record.hpp"
#include "eval/sweep/plan.hpp"

namespace cogslam {

/// What a worker measured, as it is written to `episodes/<key>.json`.
struct EpisodeResult {
  std::string key;
  std::string readings_key;
  std::string baseline;  ///< empty: none
  bool true_poses = false;
  std::string program;  ///< hash of the program's file: which build measured it
  RunRecord run;        ///< of the one variant
};

std::string to_json(const EpisodeResult& result);

}  // namespace cogslam
