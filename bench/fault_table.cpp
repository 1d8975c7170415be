// What each fault of scenarios/faults costs, and whether the filter notices: the table of docs/faults.md.
//
//   bench_fault_table SEEDS SCENARIO...     for example: bench_fault_table 10 scenarios/faults/*.yaml
//
// Each scenario is driven once for each of the seeds 1 to SEEDS; its first variant is scored. Errors of a run are roots
// of the scores of docs/metrics.md, shown as the mean over seeds and the half width of its 95 % interval (Student's t).
// `reported`: runs that say of themselves that they are degraded, and by which keys (eval/filter_degradation.hpp); for
// scenarios without a fault these are false alarms. A line per run goes to standard error.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "eval/filter_degradation.hpp"
#include "eval/stats.hpp"
#include "eval/variant_run.hpp"

namespace cogslam {
namespace {

/// One figure over the seeds.
class Figure {
 public:
  void add(const std::optional<double>& mse, double unit = 1.0) {
    if (mse) values_.push_back(unit * std::sqrt(*mse));
  }
  [[nodiscard]] std::string text(int digits) const {
    if (values_.empty()) return "-";
    const MeanInterval interval = mean_interval(values_);
    return fmt::format("{:.{}f} ± {:.{}f}", interval.mean, digits, interval.half_width, digits);
  }

 private:
  std::vector<double> values_;
};

struct Summary {
  Figure path_m, final_m, heading_deg, odometry_m, grid;
  int runs = 0, reported = 0;
  std::map<std::string_view, int> keys;
};

void print_run(const std::string& name, std::uint32_t seed, const Scores& scores) {
  const FilterHealth& h = *scores.health;
  fmt::print(
      stderr,
      "{} {}: path {:.4f} m; without scan {}, blind {}, repeated {} of {}; odometry {} of {}; headings {} of {}; "
      "scans {} of {}, in a row {}; beams {} of {}; by wheels {}; collapses {}\n",
      name, seed, std::sqrt(scores.path_mse_m2.value_or(0.0)), h.scans_missing, h.blind_scans, h.repeated_scans,
      h.records, h.odometry_doubted, h.odometry_checks, h.headings_doubted, h.headings, h.scans_doubted, h.scans_judged,
      h.longest_doubt, h.beams_doubted, h.beams_known, h.by_wheels, h.collapses);
}

void add(const Scores& scores, Summary& summary) {
  summary.path_m.add(scores.path_mse_m2);
  summary.final_m.add(scores.path_mse_final_m2);
  summary.heading_deg.add(scores.heading_mse_rad2, degrees(1.0));
  summary.odometry_m.add(scores.odometry_path_mse_m2);
  summary.grid.add(scores.grid_mse);
  ++summary.runs;
  const std::vector<Degradation> found = degradations(*scores.health);
  summary.reported += found.empty() ? 0 : 1;
  for (const Degradation& degradation : found) ++summary.keys[degradation.key];
}

std::string keys_text(const Summary& summary) {
  std::string text;
  for (const auto& [key, count] : summary.keys) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, count);
  return text;
}

void run_scenario(const std::string& file, int seeds, Workers& workers) {
  Scenario scenario = load_scenario(file);
  Summary summary;
  for (int seed = 1; seed <= seeds; ++seed) {
    scenario.seed = static_cast<std::uint32_t>(seed);
    const Drive drive = record_drive(scenario);
    if (drive.stuck) fmt::print(stderr, "{}: the vehicle was stuck\n", scenario.name);
    const VariantRun run =
        run_variant(scenario.variants.front(), scenario.seed, drive.recording, {.truth = &drive.truth}, workers);
    print_run(scenario.name, scenario.seed, run.record.scores);
    add(run.record.scores, summary);
  }
  fmt::print("| {} | {} | {} | {} | {} | {} | {} of {} | {} |\n", scenario.name, summary.path_m.text(3),
             summary.final_m.text(3), summary.heading_deg.text(2), summary.odometry_m.text(3), summary.grid.text(3),
             summary.reported, summary.runs, keys_text(summary));
  std::fflush(stdout);
}

}  // namespace
}  // namespace cogslam

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 0;
  if (argc < 3 || seeds < 1) {
    fmt::print(stderr, "usage: bench_fault_table SEEDS SCENARIO..., as in 10 scenarios/faults/*.yaml\n");
    return 2;
  }
  fmt::print(
      "| scenario | path RMSE [m] | final path [m] | heading RMSE [deg] | odometry RMSE [m] | root of grid MSE | "
      "reported | by |\n|---|---|---|---|---|---|---|---|\n");
  try {
    cogslam::Workers workers(1);
    for (int i = 2; i < argc; ++i) cogslam::run_scenario(argv[i], seeds, workers);
  } catch (const cogslam::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
