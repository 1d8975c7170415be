// How well rooms are mapped, and what compressing the maps costs: means over seeds of every variant of a scenario. The
// tables of README.md and docs/results.md.
//
//   bench_room_accuracy SEEDS CELL_SIZES SCENARIO...     for example: bench_room_accuracy 10 1,0.5,0.2,0.1
//   scenarios/*.yaml
//
// Each scenario is driven once for each of the seeds 1 to SEEDS; all variants and cell sizes consume the same readings.
// Errors of a run are roots of the scores of docs/metrics.md; the table shows their mean over seeds and, of the path,
// also the worst. `changed`: cells whose class (free, unknown, occupied) differs from the uncompressed map of the same
// run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "eval/episode.hpp"
#include "eval/metrics/map_error.hpp"

namespace cogslam {
namespace {

/// Of one figure over the seeds; runs in which it was not measured do not count.
class Mean {
 public:
  void add(const std::optional<double>& value) {
    if (!value) return;
    ++count_;
    sum_ += *value;
    most_ = std::max(most_, *value);
  }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] double mean() const { return sum_ / count_; }
  [[nodiscard]] std::string text(int digits) const { return count_ > 0 ? fmt::format("{:.{}f}", mean(), digits) : "-"; }
  [[nodiscard]] std::string most(int digits) const { return count_ > 0 ? fmt::format("{:.{}f}", most_, digits) : "-"; }

 private:
  int count_ = 0;
  double sum_ = 0.0;
  double most_ = 0.0;
};

struct Summary {
  Mean path_m, heading_deg, odometry_m, grid_mse, vs_baseline, changed_percent, payload, bytes, cpu_ms;
};

std::optional<double> root(const std::optional<double>& mse, double unit = 1.0) {
  return mse ? std::optional(unit * std::sqrt(*mse)) : std::nullopt;
}

/// The run of the uncompressed filter with the same cell size and the same kind of poses; itself where it is that run.
std::size_t baseline_of(std::size_t v, const std::vector<VariantConfig>& variants) {
  std::size_t b = 0;
  while (b < v && (variants[b].slam.store.kind != StoreKind::kDense ||
                   variants[b].slam.cell_size != variants[v].slam.cell_size ||
                   variants[b].true_poses != variants[v].true_poses)) {
    ++b;
  }
  return b;
}

double changed_percent(const GridFrame& area, const Grid<float>& a, const Grid<float>& b) {
  int changed = 0;
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const Cell c{x, y};
      changed += classify(log_odds_at(a, area, c)) != classify(log_odds_at(b, area, c)) ? 1 : 0;
    }
  }
  return 100.0 * changed / (area.width * area.height);
}

void add(const Episode& episode, const std::vector<VariantConfig>& variants, const World& world,
         std::vector<Summary>& summaries) {
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const VariantRun& run = episode.runs[v];
    const Scores& scores = episode.record.variants[v].scores;
    Summary& summary = summaries[v];
    summary.path_m.add(root(scores.path_mse_m2));
    summary.heading_deg.add(root(scores.heading_mse_rad2, degrees(1.0)));
    summary.odometry_m.add(root(scores.odometry_path_mse_m2));
    summary.grid_mse.add(scores.grid_mse);
    summary.payload.add(scores.payload_bytes);
    summary.bytes.add(scores.bytes);
    summary.cpu_ms.add(episode.record.variants[v].costs.cpu_ms_per_registered);
    const std::size_t b = baseline_of(v, variants);
    if (b == v) continue;
    summary.vs_baseline.add(scores.grid_mse_vs_baseline);
    const GridFrame area = truth_grid(world, variants[v].slam.cell_size).frame();
    summary.changed_percent.add(changed_percent(area, run.map, episode.runs[b].map));
  }
}

void print(const std::vector<VariantConfig>& variants, const std::vector<Summary>& summaries) {
  fmt::print(
      "| variant | cell [m] | path RMSE [m] (worst) | heading RMSE [deg] | odometry RMSE [m] | ratio | grid MSE | MSE "
      "to OG "
      "| changed % | payload bytes | bytes | CPU ms per scan |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const Summary& s = summaries[v];
    const bool path = !s.path_m.empty();
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", variants[v].name,
               variants[v].slam.cell_size, path ? fmt::format("{} ({})", s.path_m.text(4), s.path_m.most(4)) : "-",
               s.heading_deg.text(3), s.odometry_m.text(3),
               path ? fmt::format("{:.1f}", s.odometry_m.mean() / s.path_m.mean()) : "-", s.grid_mse.text(4),
               s.vs_baseline.empty() ? "-" : fmt::format("{:.1g}", s.vs_baseline.mean()), s.changed_percent.text(1),
               s.payload.text(0), s.bytes.text(0), s.cpu_ms.text(2));
  }
  fmt::print("\n");
  std::fflush(stdout);
}

void run_scenario(const std::string& file, const std::string& cell_sizes, int seeds, Workers& workers) {
  Scenario scenario = load_scenario(file, {{"slam.cell_sizes_m", "[" + cell_sizes + "]"}});
  std::vector<Summary> summaries(scenario.variants.size());
  for (int seed = 1; seed <= seeds; ++seed) {
    fmt::print(stderr, "{}: seed {} of {}\n", scenario.name, seed, seeds);
    scenario.seed = static_cast<std::uint32_t>(seed);
    const Drive drive = record_drive(scenario);
    if (drive.stuck) fmt::print(stderr, "{}: the vehicle was stuck\n", scenario.name);
    add(replay_variants(scenario.name, drive.recording, {.truth = &drive.truth}, scenario.variants, scenario.seed,
                        workers),
        scenario.variants, scenario.world, summaries);
  }
  fmt::print("{}, seeds 1 to {}\n\n", scenario.name, seeds);
  print(scenario.variants, summaries);
}

}  // namespace
}  // namespace cogslam

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 0;
  if (argc < 4 || seeds < 1) {
    fmt::print(stderr,
               "usage: bench_room_accuracy SEEDS CELL_SIZES SCENARIO..., as in 10 1,0.5,0.2,0.1 scenarios/*.yaml\n");
    return 2;
  }
  try {
    cogslam::Workers workers(2);
    for (int i = 3; i < argc; ++i) cogslam::run_scenario(argv[i], argv[2], seeds, workers);
  } catch (const cogslam::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
