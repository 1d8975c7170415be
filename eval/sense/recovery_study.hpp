#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "eval/lab/seeds.hpp"
#include "eval/sense/field_map.hpp"
#include "eval/sense/map_quality.hpp"
#include "eval/stats.hpp"
#include "slam/mobile_sensing/cell_samples.hpp"
#include "slam/mobile_sensing/field_recovery.hpp"

namespace cogslam {

/// How the cells to be sensed are chosen.
enum class CellChoice {
  kRandom,     ///< uniformly, mutually excluded: the paper's
  kUncertain,  ///< where the map recovered so far is uncertain (uncertain_cells.hpp)
  kRays,       ///< what a laser meets (ray_cells.hpp)
};

/// "random", "uncertain", "rays".
inline constexpr std::array<std::string_view, 3> kCellChoiceNames = {"random", "uncertain", "rays"};
std::string_view name_of(CellChoice choice);

/// Maps recovered from few of their cells: every map x choice x prior x count, over several seeds.
struct RecoveryStudy {
  std::vector<std::size_t> counts{600, 1500, 3000, 8000};  ///< K
  std::vector<FieldPrior> priors{FieldPrior::kHaar, FieldPrior::kDct, FieldPrior::kTotalVariation};
  std::vector<CellChoice> choices{CellChoice::kRandom};
  std::uint32_t first_seed = 1;
  int seeds = 5;  ///< >= 1
  double stop_at_gap = 1e-3;
  int max_iterations = 10000;
};

/// One recovery.
struct RecoveryRun {
  std::uint32_t seed = 0;
  MapQuality quality;
  double objective = 0.0;  ///< l1 norm or total variation
  double gap = 0.0;        ///< relative duality gap of the objective
  bool converged = false;  ///< the gap asked for was reached
  int iterations = 0;
  double cpu_s = 0.0;  ///< of this recovery on one core, without the choice of cells
};

/// All runs of one map, choice, prior and count.
struct RecoveryScore {
  std::string map;
  CellChoice choice{};
  FieldPrior prior{};
  std::size_t count = 0;  ///< K
  std::size_t cells = 0;  ///< N
  std::vector<RecoveryRun> runs;

  [[nodiscard]] MeanInterval mean(double MapQuality::*score) const;
  [[nodiscard]] MeanInterval mean_objective() const;
  [[nodiscard]] double largest_gap() const;
  [[nodiscard]] int converged() const;  ///< how many runs
  [[nodiscard]] double mean_iterations() const;
  [[nodiscard]] double mean_cpu_s() const;
};

/// Senses `count` cells of a map.
CellSamples sense_map(const FieldMap& map, CellChoice choice, std::size_t count, std::uint32_t seed);

/// InputError for a count of 0 or beyond a map's cells.
void check(const RecoveryStudy& study, const std::vector<FieldMap>& maps);

/// In the order map, choice, prior, count. All but times is the same for any number of threads. Checks the study first.
std::vector<RecoveryScore> run_recovery_study(const RecoveryStudy& study, const std::vector<FieldMap>& maps,
                                              Workers& workers, const LabProgress& progress);

/// For people: a line per score.
std::string recovery_table(const std::vector<RecoveryScore>& scores);
/// A line per score, with 95 % intervals and, in the last columns, times.
std::string recovery_csv(const std::vector<RecoveryScore>& scores);
/// Everything, every run included; what is infinite is null.
std::string recovery_json(const RecoveryStudy& study, const std::vector<RecoveryScore>& scores);

}  // namespace cogslam
