#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/lab.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "eval/lab/map_source.hpp"
#include "eval/lab/map_study.hpp"
#include "eval/lab/map_table.hpp"
#include "eval/lab/method.hpp"

namespace cogslam {
namespace {

struct MapArguments {
  LabOptions options;
  std::string map;
  double cell_size = 0.1;  // [m]
  std::vector<std::string> bases{"haar"}, compressors{"top_m"}, recoveries{"fast_l2"};
  std::vector<double> percents{5, 10, 20, 30, 40, 60, 80, 100};
  std::uint32_t seed = 1;
  bool csv = false;
};

/// The kinds of these names; `kinds` holds every one there is.
template <class Kind>
std::vector<Kind> kinds_named(const std::string& what, const std::vector<std::string>& names,
                              const std::vector<Kind>& kinds) {
  std::vector<std::string> known;
  for (const Kind kind : kinds) known.emplace_back(name_of(kind));
  std::vector<Kind> chosen;
  for (const std::string& name : names) chosen.push_back(kinds[index_of_name(what, name, known)]);
  return chosen;
}

MapStudy study_of(const MapArguments& arguments) {
  using enum BasisKind;
  for (const double percent : arguments.percents) {
    if (percent > 0.0 && percent <= 100.0) continue;
    throw InputError("--percent " + number_text(percent) + ": expected more than 0 and at most 100");
  }
  const std::vector<BasisKind> bases{kHaar, kHaarStandard, kHaar1d, kDct, kDct1d, BasisKind::kHadamard, kIdentity};
  const std::vector<CompressorKind> compressors{CompressorKind::kTopM,     CompressorKind::kSelection,
                                                CompressorKind::kGaussian, CompressorKind::kHadamard,
                                                CompressorKind::kDct,      CompressorKind::kNoiselet};
  return {.bases = kinds_named("basis", arguments.bases, bases),
          .compressors = kinds_named("compressor", arguments.compressors, compressors),
          .recoveries = arguments.recoveries,
          .percents = arguments.percents,
          .seed = arguments.seed};
}

int run(const MapArguments& arguments) {
  const MapStudy study = study_of(arguments);
  const Grid<float> map = lab_map(arguments.map, arguments.cell_size);
  ProgressLine progress(1, arguments.options.quiet);
  Workers workers(arguments.options.threads);
  const std::string title =
      fmt::format("{}: {} x {} = {} cells", arguments.map, map.frame().width, map.frame().height, map.frame().size());
  const std::vector<MapScore> scores = run_map_study(study, map, workers, progress.begin()(title));
  progress.end_stage();
  progress.clear();
  if (arguments.csv) {
    fmt::print("{}", map_csv(scores));
  } else {
    fmt::print("{}\n\n{}\n{}", title, map_table(scores), yardstick_table(map));
  }
  return kOk;
}

}  // namespace

Command lab_map_command(CLI::App& lab) {
  auto arguments = std::make_shared<MapArguments>();
  CLI::App* parser = lab.add_subcommand("map", "a map through basis x compressor x recovery, beside plain storage");
  parser->footer(
      "MAP is one of\n"
      "  a file .npy: two dimensions, float32 or float64, little-endian, C order, as the folder of a run has them;\n"
      "  any other file: text, numbers separated by commas, a line per row, all rows of one length;\n"
      "  simple, cornered, cluttered: the ideal map of that room in cells of --cell-size.\n"
      "Values are log-odds and must be finite; the first row of a file is the bottom of the map. Anything else ends "
      "with\n"
      "exit code 2 and FILE:LINE:COLUMN, what is wrong and what was expected. Combinations that do not exist are rows\n"
      "that say why. Bytes: values as float32, with the index of top_m as u32, u16 or bitmap; the others need the "
      "seed\n"
      "alone, 4 bytes.");
  parser->add_option("MAP", arguments->map, "map of log-odds: a file, or a room; see below")->required();
  parser->add_option("--cell-size", arguments->cell_size, "of a room [m]")
      ->check(number_in(0.005, 100.0))
      ->capture_default_str();
  parser->add_option("--basis", arguments->bases, "haar, haar_standard, haar_1d, dct, dct_1d, hadamard, identity")
      ->capture_default_str();
  parser->add_option("--compressor", arguments->compressors, "top_m, selection, gaussian, hadamard, dct, noiselet")
      ->capture_default_str();
  parser->add_option("--recovery", arguments->recoveries, fmt::format("{}", fmt::join(kRecoveryNames, ", ")))
      ->capture_default_str();
  parser->add_option("--percent", arguments->percents, "measurements, of 100 per map cell")->capture_default_str();
  parser->add_option("--seed", arguments->seed, "of random compressors")->capture_default_str();
  parser->add_flag("--csv", arguments->csv, "print CSV without times in place of the tables");
  add_lab_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
