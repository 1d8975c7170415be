#pragma once

#include <functional>
#include <string>
#include <vector>

#include "eval/variant_run.hpp"

namespace cogslam {

/// Called where a stage of a long job begins; what it returns is told how far the stage has come. Throw from either to
/// stop the job.
using StageBegin = std::function<Progress(const std::string& stage)>;

/// What came of one set of readings.
struct Episode {
  RunRecord record;
  std::vector<VariantRun> runs;  ///< in the order of the variants
};

/// "og 0.1 m": a variant and its cell size.
std::string label(const VariantConfig& variant);
std::string label(const VariantRecord& variant);

/// Replays the readings through every variant, scores each, and compares them with the baseline. Variants that map
/// from true poses need `evidence.truth`. Without a single scan nothing can be measured: the record then has no
/// variants. With `limits` every run keeps a trace.
Episode replay_variants(const std::string& name, const Recording& recording, const Evidence& evidence,
                        const std::vector<VariantConfig>& variants, std::uint32_t seed, Workers& workers,
                        const StageBegin& begin = {}, const std::optional<TraceLimits>& limits = {});

}  // namespace cogslam
