#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/sense.hpp"
#include "core/error.hpp"
#include "eval/lab/method.hpp"
#include "eval/sense/recovery_study.hpp"

namespace cogslam {
namespace {

struct RecoverArguments {
  SenseOptions options;
  std::vector<std::filesystem::path> maps;
  std::vector<std::int64_t> counts{600, 1500, 3000, 8000};
  std::vector<std::string> priors{"haar", "dct", "tv"}, choices{"random"};
  RecoveryStudy study;
  bool csv = false, json = false;
};

template <class Kind, class Names>
std::vector<Kind> kinds_named(const std::string& what, const std::vector<std::string>& chosen, const Names& names) {
  const std::vector<std::string> known(names.begin(), names.end());
  std::vector<Kind> kinds;
  for (const std::string& name : chosen) kinds.push_back(static_cast<Kind>(index_of_name(what, name, known)));
  return kinds;
}

RecoveryStudy study_of(const RecoverArguments& arguments) {
  RecoveryStudy study = arguments.study;
  study.priors = kinds_named<FieldPrior>("prior", arguments.priors, kFieldPriorNames);
  study.choices = kinds_named<CellChoice>("choice of cells", arguments.choices, kCellChoiceNames);
  study.counts.clear();
  for (const std::int64_t count : arguments.counts) {
    if (count < 1) throw InputError(fmt::format("K = {}: expected at least one cell to sense", count));
    study.counts.push_back(static_cast<std::size_t>(count));
  }
  return study;
}

int run(const RecoverArguments& arguments) {
  const RecoveryStudy study = study_of(arguments);
  std::vector<FieldMap> maps;
  for (const std::filesystem::path& file : arguments.maps) maps.push_back(read_field_map(file));
  check(study, maps);
  ProgressLine progress(1, arguments.options.quiet);
  Workers workers(arguments.options.threads);
  const std::string title = fmt::format("{} maps, seeds {} to {}", maps.size(), study.first_seed,
                                        study.first_seed + static_cast<std::uint32_t>(study.seeds) - 1);
  const std::vector<RecoveryScore> scores = run_recovery_study(study, maps, workers, progress.begin()(title));
  progress.end_stage();
  progress.clear();
  if (arguments.json) {
    fmt::print("{}", recovery_json(study, scores));
  } else if (arguments.csv) {
    fmt::print("{}", recovery_csv(scores));
  } else {
    fmt::print("{}, mean +- 95 % interval; gap: the largest, relative; ended: runs that reached {}\n\n{}", title,
               study.stop_at_gap, recovery_table(scores));
  }
  return kOk;
}

}  // namespace

Command sense_recover_command(CLI::App& sense) {
  auto arguments = std::make_shared<RecoverArguments>();
  CLI::App* parser = sense.add_subcommand("recover", "maps from K of their cells, by sparsity and by total variation");
  parser->add_option("MAP", arguments->maps, kFieldMapFiles)->required();
  parser->add_option("--samples", arguments->counts, "K: cells to sense")->type_name("K")->capture_default_str();
  parser->add_option("--prior", arguments->priors, fmt::format("{}", fmt::join(kFieldPriorNames, ", ")))
      ->capture_default_str();
  parser->add_option("--cells", arguments->choices, fmt::format("chosen how: {}", fmt::join(kCellChoiceNames, ", ")))
      ->capture_default_str();
  parser->add_option("--seed", arguments->study.first_seed, "the first one")->capture_default_str();
  parser->add_option("--seeds", arguments->study.seeds, "draws of cells behind every mean")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  parser->add_option("--gap", arguments->study.stop_at_gap, "relative duality gap that ends a recovery")
      ->check(number_in(1e-9, 1.0))
      ->capture_default_str();
  parser->add_option("--iterations", arguments->study.max_iterations, "most of one recovery")
      ->check(CLI::Range(0, 100000000))
      ->capture_default_str();
  CLI::Option* csv = parser->add_flag("--csv", arguments->csv, "print CSV in place of the table");
  parser->add_flag("--json", arguments->json, "print JSON, every run included")->excludes(csv);
  add_sense_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
