#include "eval/sense/recovery_study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/check.hpp"
#include "core/error.hpp"
#include "eval/metrics/timing.hpp"
#include "slam/mobile_sensing/ray_cells.hpp"
#include "slam/mobile_sensing/uncertain_cells.hpp"

namespace cogslam {
namespace {

std::vector<RecoveryScore> empty_scores(const RecoveryStudy& study, const std::vector<FieldMap>& maps) {
  std::vector<RecoveryScore> scores;
  for (const FieldMap& map : maps) {
    for (const CellChoice choice : study.choices) {
      for (const FieldPrior prior : study.priors) {
        for (const std::size_t count : study.counts) {
          scores.push_back({map.name, choice, prior, count, map.cells.size(),
                            std::vector<RecoveryRun>(static_cast<std::size_t>(study.seeds))});
        }
      }
    }
  }
  return scores;
}

RecoveryRun run_one(const RecoveryStudy& study, const FieldMap& map, const RecoveryScore& score, std::uint32_t seed) {
  const CellSamples samples = sense_map(map, score.choice, score.count, seed);
  const Stopwatch watch(Clock::kThreadCpu);
  const RecoveredField recovered = recover_field({score.prior, study.stop_at_gap, study.max_iterations}, samples);
  return {.seed = seed,
          .quality = map_quality(map.cells, recovered.field),
          .objective = recovered.objective,
          .gap = *recovered.solver.duality_gap,
          .converged = recovered.solver.converged,
          .iterations = recovered.solver.iterations,
          .cpu_s = watch.seconds()};
}

template <class Value>
std::vector<double> of_all(const std::vector<RecoveryRun>& runs, Value value) {
  std::vector<double> values;
  for (const RecoveryRun& run : runs) values.push_back(static_cast<double>(value(run)));
  return values;
}

}  // namespace

void check(const RecoveryStudy& study, const std::vector<FieldMap>& maps) {
  EXPECTS(study.seeds >= 1);
  for (const FieldMap& map : maps) {
    for (const std::size_t count : study.counts) {
      if (count == 0) throw InputError("K = 0: expected at least one cell to sense");
      if (count <= map.cells.size()) continue;
      throw InputError(fmt::format("K = {} is more than the {} cells of map '{}'", count, map.cells.size(), map.name));
    }
  }
}

std::string_view name_of(CellChoice choice) { return kCellChoiceNames[static_cast<std::size_t>(choice)]; }

MeanInterval RecoveryScore::mean(double MapQuality::*score) const {
  return mean_interval(of_all(runs, [score](const RecoveryRun& run) { return run.quality.*score; }));
}
MeanInterval RecoveryScore::mean_objective() const {
  return mean_interval(of_all(runs, [](auto& r) { return r.objective; }));
}
double RecoveryScore::largest_gap() const {
  return std::ranges::max(of_all(runs, [](auto& r) { return r.gap; }));
}
int RecoveryScore::converged() const {
  return static_cast<int>(std::ranges::count_if(runs, [](auto& r) { return r.converged; }));
}
double RecoveryScore::mean_iterations() const {
  return mean_interval(of_all(runs, [](auto& r) { return r.iterations; })).mean;
}
double RecoveryScore::mean_cpu_s() const {
  return mean_interval(of_all(runs, [](auto& r) { return r.cpu_s; })).mean;
}

CellSamples sense_map(const FieldMap& map, CellChoice choice, std::size_t count, std::uint32_t seed) {
  const CellSensor sensor = [&map](std::uint32_t cell) { return map.cells[cell]; };
  switch (choice) {
    case CellChoice::kUncertain:
      return sense_uncertain_cells({}, map.width, map.height, count, seed, sensor);
    case CellChoice::kRays:
      return sense_ray_cells({}, map.width, map.height, count, seed, sensor);
    case CellChoice::kRandom:
      break;
  }
  return sense_random_cells(map.width, map.height, count, seed, sensor);
}

std::vector<RecoveryScore> run_recovery_study(const RecoveryStudy& study, const std::vector<FieldMap>& maps,
                                              Workers& workers, const LabProgress& progress) {
  check(study, maps);
  std::vector<RecoveryScore> scores = empty_scores(study, maps);
  const auto seeds = static_cast<std::size_t>(study.seeds);
  const std::size_t scores_per_map = maps.empty() ? 0 : scores.size() / maps.size();
  for_each_seed(scores.size() * seeds, workers, progress, [&](std::size_t index) {
    RecoveryScore& score = scores[index / seeds];
    const auto seed = study.first_seed + static_cast<std::uint32_t>(index % seeds);
    score.runs[index % seeds] = run_one(study, maps[index / seeds / scores_per_map], score, seed);
  });
  return scores;
}

}  // namespace cogslam
