#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/sense_path.hpp"
#include "core/error.hpp"
#include "eval/sense/hallway_study.hpp"

namespace cogslam {
namespace {

struct HallwayArguments {
  SenseOptions options;
  HallwayStudy study;
  bool csv = false;
};

int run(const HallwayArguments& arguments) {
  const HallwayStudy& study = arguments.study;
  expect_right(study.correction.check());
  expect_right(study.drive.check());
  Workers workers(arguments.options.threads);
  const std::vector<HallwayScore> scores = run_hallway_study(study, workers);
  if (arguments.csv) {
    fmt::print("{}", hallway_csv(scores));
  } else {
    const PathCorrectionConfig& correction = study.correction;
    fmt::print(
        "hallway, looks at most {} m and {:.0f} deg apart, partial maps of {} x {} cells, {} of {} sampled\n\n{}",
        study.drive.step_m, degrees(study.drive.step_turn), correction.map.across_cells, correction.map.ahead_cells,
        correction.samples, correction.map.cells(), hallway_table(scores));
  }
  return kOk;
}

}  // namespace

Command sense_hallway_command(CLI::App& sense) {
  auto arguments = std::make_shared<HallwayArguments>();
  CLI::App* parser = sense.add_subcommand("hallway", "a path through a hallway, corrected by its partial maps");
  HallwayStudy& study = arguments->study;
  parser->add_option("--seeds", study.seeds, "drives")->check(CLI::Range(1, 10000))->capture_default_str();
  parser->add_option("--seed", study.first_seed, "the first one")->capture_default_str();
  parser->add_option("--samples", study.correction.samples, "K: cells sampled of each partial map")
      ->type_name("K")
      ->capture_default_str();
  parser->add_option("--step", study.drive.step_m, "from one look to the next [m]")->capture_default_str();
  parser->add_option("--across", study.correction.map.across_cells, "cells of a partial map to both sides")
      ->capture_default_str();
  parser->add_option("--ahead", study.correction.map.ahead_cells, "cells of a partial map ahead")
      ->capture_default_str();
  parser->add_option("--cell-size", study.correction.map.cell_size_m, "[m]")->capture_default_str();
  parser->add_flag("--csv", arguments->csv, "print CSV in place of the table");
  add_sense_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
