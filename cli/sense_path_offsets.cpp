#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/sense_path.hpp"
#include "core/error.hpp"
#include "eval/lab/method.hpp"
#include "eval/sense/path_offset_study.hpp"

namespace cogslam {
namespace {

const std::vector<std::string> kSources{"drawn", "scanned"};

struct OffsetsArguments {
  SenseOptions options;
  OffsetStudy study;
  std::vector<std::string> sources = kSources;
  bool csv = false;
};

int run(const OffsetsArguments& arguments) {
  Workers workers(arguments.options.threads);
  for (const std::string& source : arguments.sources) {
    OffsetStudy study = arguments.study;
    study.source = static_cast<OffsetSource>(index_of_name("source", source, kSources));
    expect_right(study.check());
    const std::vector<OffsetDraw> draws = run_offset_study(study, workers);
    if (arguments.csv) {
      fmt::print("{}", offset_csv(draws));
      continue;
    }
    fmt::print("{}: {} pairs, seed {}, up to {} cells and {:.0f} deg, {} of {} cells sampled\n{}\n", source,
               study.draws, study.seed, study.most_cells, degrees(study.most_turn),
               study.samples == 0 ? study.map.cells() : study.samples, study.map.cells(),
               offset_table(summarise(draws)));
  }
  return kOk;
}

}  // namespace

Command sense_offsets_command(CLI::App& sense) {
  auto arguments = std::make_shared<OffsetsArguments>();
  CLI::App* parser = sense.add_subcommand("offsets", "how well a random offset between two partial maps is found");
  parser
      ->add_option("--source", arguments->sources,
                   "drawn: of the world itself; scanned: one laser sweep each; both where none is named")
      ->type_name("NAME");
  parser->add_option("--draws", arguments->study.draws, "pairs")->check(CLI::Range(1, 1000000))->capture_default_str();
  parser->add_option("--seed", arguments->study.seed, "of places, offsets, noise and cells")->capture_default_str();
  parser->add_option("--samples", arguments->study.samples, "K: cells sampled of each map; 0: all")
      ->type_name("K")
      ->capture_default_str();
  parser->add_flag("--csv", arguments->csv, "print every draw as CSV in place of the summary");
  add_sense_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
