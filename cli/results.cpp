#include "cli/results.hpp"

#include <fmt/format.h>
#include <unistd.h>

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

}  // namespace

void check_out(const Options& options) {
  if (options.no_files) return;
  if (options.out.empty()) throw InputError("--out: expected a folder, found nothing");
  std::filesystem::path at = std::filesystem::absolute(options.out);
  std::error_code error;
  while (!std::filesystem::exists(at, error) && at.has_relative_path()) at = at.parent_path();
  if (!std::filesystem::is_directory(at, error) || access(at.c_str(), W_OK | X_OK) != 0) {
    throw InputError("--out " + options.out.string() + ": expected a folder that can be written to");
  }
}

int publish(const RunFiles& files, const Options& options, ProgressLine& progress) {
  progress.end_stage();
  if (files.episode.runs.empty()) {
    progress.warn("nothing measured: the readings hold no scan");
    return kNothingMeasured;
  }
  if (!options.no_files) {  // before the table: whoever reads that may stop reading
    const std::filesystem::path folder = write_run_folder(options.out, files, progress.begin());
    progress.say("wrote " + folder.string());
  }
  progress.clear();
  print_record(files.episode.record, options.json);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw InputError("standard output: cannot write the result");
  return kOk;
}

}  // namespace cogslam
