#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "eval/metrics/relations.hpp"
#include "eval/recorder.hpp"
#include "eval/run_record.hpp"
#include "eval/run_trace.hpp"
#include "eval/scenario.hpp"

namespace cogslam {

/// What a path and a map can be held against. Any part may be missing: a real log has no truth.
struct Evidence {
  const TruthLog* truth = nullptr;
  std::span<const Relation> relations{};
};

/// One variant, run and scored, with what pictures and files are made of.
struct VariantRun {
  VariantRecord record;
  std::vector<Pose2> online;  ///< one pose per reading
  std::vector<Pose2> final;   ///< one pose per reading
  Grid<float> map;
  std::optional<RunTrace> trace;  ///< where one was asked for
};

/// As in scenario files and records.
std::string store_name(StoreKind kind);

/// Odometry alone, from the start pose: one pose per reading.
std::vector<Pose2> odometry_path(const Recording& recording);

/// Replays the readings through one variant and scores it. A variant that maps from true poses needs
/// `evidence.truth`; its own path is not scored. With `limits` it also keeps a trace; that changes no score, and costs
/// do not count the time it takes.
VariantRun run_variant(const VariantConfig& variant, std::uint32_t seed, const Recording& recording,
                       const Evidence& evidence, Workers& workers, const Progress& progress = {},
                       const std::optional<TraceLimits>& limits = {});

/// Adds the comparisons with the uncompressed filter of the same cell size and poses (design: the first dense variant).
void compare_with_baseline(std::vector<VariantRun>& runs, const std::vector<VariantConfig>& variants,
                           const Recording& recording, const TruthLog* truth);

}  // namespace cogslam
