#include "cli/results.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>
#include "cli/exit_codes.hpp"
#include "eval/report/table.hpp"

namespace cogslam {
namespace {

std::string costs_text(const RunRecord& record) {
  double cpu = 0.0, wall = 0.0;
  for (const VariantRecord& variant : record.variants) {
    cpu += variant.costs.cpu_s.value_or(0.0);
    wall += variant.costs.wall_s.value_or(0.0);
  }
  return fmt::format("filters: {:.1f} s CPU, {:.1f} s wall; readings {}\n", cpu, wall,
                     record.readings_hash.value_or("-"));
}

void print_record(const RunRecord& record, bool json) {
  if (json) {
    fmt::print("{}", to_json(record));
    return;
  }
  fmt::print("{}", score_table(record));
  if (const std::string relations = relations_table(record); !relations.empty()) fmt::print("\n{}", relations);
  fmt::print("\n{}", costs_text(record));
}

/// Once per kind of degradation, not once per filter.
void warn_of_degradation(const RunRecord& record, ProgressLine& progress) {
  std::map<std::string_view, std::pair<int, std::string_view>> found;
  for (const VariantRecord& variant : record.variants) {
    for (const Degradation& degradation : variant.scores.degraded) {
      auto& [count, words] = found[degradation.key];
      words = degradation.words;
      ++count;
    }
  }
  for (const auto& [key, what] : found) {
    progress.warn(fmt::format("degraded result ({}, {} of {} filters): {}", key, what.first, record.variants.size(),
                              what.second));
  }
}

}  // namespace

void check_out(const Options& options) {
  if (!options.no_files) check_out_folder(options.out);
}

int publish(const RunFiles& files, const Options& options, ProgressLine& progress) {
  progress.end_stage();
  if (files.episode.runs.empty()) {
    progress.warn("nothing measured: the readings hold no scan");
    return kNothingMeasured;
  }
  warn_of_degradation(files.episode.record, progress);
  if (!options.no_files) {  // before the table: whoever reads that may stop reading
    const std::filesystem::path folder = write_run_folder(options.out, files, progress.begin());
    progress.say("wrote " + folder.string());
  }
  progress.clear();
  print_record(files.episode.record, options.json);
  return kOk;
}

}  // namespace cogslam
