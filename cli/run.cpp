#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/results.hpp"

namespace cogslam {
namespace {

struct RunArguments {
  Options options;
  std::filesystem::path scenario;
};

void tell_of_drive(const Drive& drive, ProgressLine& progress) {
  if (drive.camera_spans_without > 0) {
    progress.say(fmt::format("no estimate from the camera in {} of {} spans: wheels stood in",
                             drive.camera_spans_without, drive.camera_spans));
  }
  if (drive.pictures_repeated > 0) {
    progress.say(fmt::format("{} pictures of the camera equal the one before: it was frozen", drive.pictures_repeated));
  }
  if (drive.stuck) progress.warn("the vehicle was stuck for 5 s at some time: look at the route");
}

int run(const RunArguments& arguments) {
  const Options& options = arguments.options;
  check_out(options);
  const Scenario scenario = load_scenario(arguments.scenario, overrides_of(options, arguments.scenario));
  const std::vector<VariantConfig> variants = chosen_variants(options, scenario.variants);
  ProgressLine progress(static_cast<int>(variants.size()) + (options.no_files ? 1 : 2), options.quiet);
  const StageBegin begin = progress.begin();

  const Drive drive = record_drive(scenario, begin("simulating " + scenario.name));
  tell_of_drive(drive, progress);
  Workers workers(options.threads);
  const Episode episode = replay_variants(scenario.name, drive.recording, {.truth = &drive.truth}, variants,
                                          scenario.seed, workers, begin, trace_limits(options));
  const RunFiles files{.episode = episode,
                       .recording = drive.recording,
                       .truth = &drive.truth,
                       .config_name = "scenario.yaml",
                       .config = choice_comment(options) + scenario.resolved,
                       .page = options.page,
                       .save_readings = options.save_readings};
  return publish(files, options, progress);
}

}  // namespace

Command run_command(CLI::App& program) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* parser = program.add_subcommand("run", "simulate a scenario, run its filters on the readings, score them");
  parser->add_option("SCENARIO", arguments->scenario, "scenario file (YAML)")->required();
  add_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
