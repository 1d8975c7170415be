// A real log, many seeds: accuracy by the benchmark's relations, bytes and CPU time from the same runs. The table of
// docs/results.md.
//
//   bench_log_accuracy LOG RELATIONS FIRST_SEED LAST_SEED [STORE]     STORE: tiles (the default), lattice or dense
//
// The defaults of `cogslam replay`, one thread. A run leaves a loop open when its mean global error is over 0.1 m.
// Conclusion, of two virtual cores of an Intel Xeon at 2.6 GHz: see docs/results.md.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "eval/episode.hpp"
#include "eval/replay_source.hpp"

namespace cogslam {
namespace {

constexpr double kOpen = 0.1;  // m

/// One figure over the seeds.
struct Column {
  std::string name;
  int digits;
  std::vector<double> values{};

  void print() const {
    double sum = 0.0;
    for (const double value : values) sum += value;
    fmt::print("{:24} {:>12.{}f} {:>12.{}f}\n", name, sum / static_cast<double>(values.size()), digits,
               *std::max_element(values.begin(), values.end()), digits);
  }
};

std::vector<Column> empty_columns() {
  std::vector<Column> columns{{"local [m]", 4},   {"local [deg]", 3},         {"global [m]", 4}, {"global [deg]", 3},
                              {"CPU [s]", 1},     {"bytes all-in", 0},        {"payload", 0},    {"peak bytes", 0},
                              {"resamplings", 0}, {"RSS above start [MB]", 1}};
  for (std::size_t s = 0; s < kStages; ++s) {
    columns.push_back({fmt::format("CPU {} [s]", name_of(static_cast<Stage>(s))), 2});
  }
  return columns;
}

/// In the order of the columns.
std::vector<double> figures_of(const VariantRecord& record) {
  const RelationErrors& errors = record.scores.relations_final.value();
  const Scores& scores = record.scores;
  std::vector<double> figures{errors.local.trans_mean,
                              degrees(errors.local.rot_mean),
                              errors.global.trans_mean,
                              degrees(errors.global.rot_mean),
                              record.costs.cpu_s.value(),
                              scores.bytes.value(),
                              scores.payload_bytes.value(),
                              static_cast<double>(scores.bytes_peak.value()),
                              static_cast<double>(scores.resamplings.value()),
                              1e-6 * static_cast<double>(record.costs.rss_bytes_above_start.value_or(0))};
  for (const double seconds : record.costs.cpu_stages_s.value()) figures.push_back(seconds);
  return figures;
}

int run(const std::string& log, const std::string& relations_file, int first, int last, const std::string& store) {
  ConfigSection section = ConfigSection::parse("", "defaults");
  section.override_value("slam.store.kind", store);
  const ReplayConfig config = read_replay_config(std::move(section));
  const Recording recording = load_log(log, config.log);
  const std::vector<Relation> relations = read_relations(relations_file);
  Workers workers(1);
  std::vector<Column> columns = empty_columns();
  int open = 0;
  for (int seed = first; seed <= last; ++seed) {
    const Episode episode = replay_variants(log_name(log), recording, {.relations = relations}, config.variants,
                                            static_cast<std::uint32_t>(seed), workers);
    const std::vector<double> figures = figures_of(episode.runs.front().record);
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].values.push_back(figures[i]);
    if (figures[2] > kOpen) ++open;
    fmt::print("seed {:3}: local {:.4f} m, {:.3f} deg; global {:.4f} m, {:.3f} deg; {:.1f} s\n", seed, figures[0],
               figures[1], figures[2], figures[3], figures[4]);
    std::fflush(stdout);
  }
  fmt::print("\n{:24} {:>12} {:>12}\n", fmt::format("{}, {}", log_name(log), store), "mean", "worst");
  for (const Column& column : columns) column.print();
  fmt::print("runs with an open loop: {} of {}\n", open, last - first + 1);
  return 0;
}

}  // namespace
}  // namespace cogslam

int main(int argc, char** argv) {
  if (argc < 5 || std::atoi(argv[3]) > std::atoi(argv[4])) {
    fmt::print(stderr, "usage: bench_log_accuracy LOG RELATIONS FIRST_SEED LAST_SEED [STORE]\n");
    return 2;
  }
  try {
    return cogslam::run(argv[1], argv[2], std::atoi(argv[3]), std::atoi(argv[4]), argc > 5 ? argv[5] : "tiles");
  } catch (const cogslam::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
