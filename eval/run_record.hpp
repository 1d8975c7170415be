#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/degradation.hpp"
#include "eval/metrics/relations.hpp"
#include "eval/metrics/stage_times.hpp"
#include "slam/health/filter_health.hpp"

// What a run is worth: the content of scores.json, schema 1. Nothing stands for "not measured" and is written as null,
// never as 0; so is a number that is not finite. docs/metrics.md defines every figure.

namespace cogslam {

inline constexpr int kRunRecordSchema = 1;

/// Figures that are the same, bit by bit, for the same program, scenario and seed.
struct Scores {
  std::optional<double> path_mse_m2;                                        ///< online path
  std::optional<double> heading_mse_rad2;                                   ///< online path
  std::optional<double> path_mse_final_m2;                                  ///< final path
  std::optional<double> heading_mse_final_rad2;                             ///< final path
  std::optional<double> odometry_path_mse_m2;                               ///< odometry alone
  std::optional<double> odometry_heading_mse_rad2;                          ///< odometry alone
  std::optional<double> ate_rmse_m;                                         ///< online path, aligned
  std::optional<double> rpe_trans_m;                                        ///< online path, per metre travelled
  std::optional<double> rpe_rot_rad;                                        ///< online path, per metre travelled
  std::optional<double> grid_mse;                                           ///< observable cells
  std::optional<double> grid_mse_all;                                       ///< all cells
  std::optional<double> grid_mse_logodds;                                   ///< all cells
  std::optional<double> grid_log_score;                                     ///< observable cells [nats]
  std::optional<std::array<std::array<std::size_t, 3>, 2>> grid_confusion;  ///< truth x belief, see MapError
  std::optional<double> path_mse_vs_baseline_m2;                            ///< online path against the baseline's
  std::optional<double> grid_mse_vs_baseline;                               ///< all cells
  std::optional<std::uint64_t> registered;                                  ///< scans that changed the map
  std::optional<std::uint64_t> tracked;  ///< scans in between: odometry alone moved the pose
  std::optional<std::uint64_t> resamplings;
  std::optional<std::uint64_t> ancestors_100;  ///< distinct ancestors, 100 updates back
  std::optional<double> payload_bytes;         ///< per particle, mean over registered scans
  std::optional<double> payload_bytes_bitmap;  ///< the same with a bitmap for the index; coefficients only
  std::optional<double> bytes;                 ///< all-in, per particle, mean over registered scans
  std::optional<std::uint64_t> bytes_peak;     ///< all-in, per particle, peak
  std::vector<Degradation> degraded;           ///< why the figures above mean less than usual; empty: nothing of note
  std::optional<FilterHealth> health;          ///< signs that readings and belief do not go together
  std::optional<std::string> state_hash;       ///< of the filter at the end
  std::optional<std::string> map_hash;         ///< of the final map
  std::optional<RelationErrors> relations_online;
  std::optional<RelationErrors> relations_final;
};

/// Figures of this machine at this hour; never compared for identity.
struct Costs {
  std::optional<double> cpu_s;  ///< of the filter, all threads
  std::optional<double> cpu_ms_per_registered;
  std::optional<StageSeconds> cpu_stages_s;  ///< of cpu_s, for each Stage; the rest is between stages
  std::optional<double> wall_s;
  std::optional<std::uint64_t> rss_bytes_above_start;
};

/// One configuration of the filter, run on the readings of the record.
struct VariantRecord {
  std::string name;
  std::string store;  ///< dense, coefficients, tiles, ...
  double cell_size_m = 0.0;
  std::optional<double> percent_kept;  ///< 100 m/n of coefficients; nothing for stores that keep no share
  std::optional<std::string> basis;    ///< of kept coefficients, by their names in a scenario; nothing for other stores
  std::optional<std::string> compressor;
  std::optional<std::string> recovery;
  int particles = 0;
  Scores scores;
  Costs costs;
};

/// One run: one set of readings through several variants.
struct RunRecord {
  std::string scenario;
  std::uint32_t seed = 0;
  std::optional<std::string> readings_hash;
  std::optional<double> simulated_s;  ///< span of the readings
  std::vector<VariantRecord> variants;
};

/// The record as one JSON object. Same record, same bytes: keys stand in a fixed order, numbers are written as short
/// as reads back exactly. Angles are radians, but relations errors are degrees, as the benchmark reports them.
std::string to_json(const RunRecord& record);

/// The same without costs: all that a run has in common with its repetitions.
std::string lasting_json(const RunRecord& record);

/// The `scores` parts alone, in the order of the variants: what two runs must share byte for byte.
std::string scores_json(const RunRecord& record);

}  // namespace cogslam
