#pragma once

#include <string>

#include "eval/run_record.hpp"

namespace cogslam {

/// The table a user sees at the end of a run: a row per variant. A figure that was not measured is "-".
std::string score_table(const RunRecord& record);

/// Relations errors, a row per variant, path (online, final) and split (local, global, all); empty where no variant has
/// any.
std::string relations_table(const RunRecord& record);

}  // namespace cogslam
