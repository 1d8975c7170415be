#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/results.hpp"
#include "eval/replay_source.hpp"

namespace cogslam {
namespace {

struct ReplayArguments {
  Options options;
  std::filesystem::path log;
  std::filesystem::path config;
  std::filesystem::path scenario;
  std::filesystem::path truth;
  std::filesystem::path relations;
  std::string area;
};

/// From a scenario, from a configuration, or from the defaults for logs.
ReplayConfig load_config(const ReplayArguments& arguments) {
  const Options& options = arguments.options;
  const std::filesystem::path& file = arguments.scenario.empty() ? arguments.config : arguments.scenario;
  const Overrides overrides = overrides_of(options, file);
  if (!arguments.scenario.empty()) {
    Scenario scenario = load_scenario(file, overrides);
    return {.seed = scenario.seed, .variants = std::move(scenario.variants), .resolved = std::move(scenario.resolved)};
  }
  ConfigSection section = file.empty() ? ConfigSection::parse("", "options of replay") : ConfigSection::load(file);
  if (!arguments.area.empty()) {
    section.override_value("map.area_m", "[" + arguments.area + "]", "--area " + arguments.area);
  }
  for (const auto& [path, text] : overrides) section.override_value(path, text);
  return read_replay_config(std::move(section));
}

std::optional<TruthLog> load_truth(const std::filesystem::path& file, const Recording& recording) {
  if (file.empty()) return std::nullopt;
  TruthLog truth = read_truth_log(file);
  const std::size_t poses = truth.poses.size(), readings = recording.readings.size();
  if (poses != readings) {
    throw InputError({file.string()},
                     fmt::format("holds {} true poses, expected one for each of {} readings", poses, readings));
  }
  if (truth.readings_hash != readings_hash(recording.readings)) {
    throw InputError({file.string()}, "the truth of other readings (" + truth.readings_hash + "), expected that of " +
                                          readings_hash(recording.readings));
  }
  return truth;
}

/// Without the truth nobody can map from true poses.
std::vector<VariantConfig> possible_variants(std::vector<VariantConfig> variants, bool truth_known,
                                             ProgressLine& progress) {
  if (truth_known) return variants;
  const auto left_out = std::erase_if(variants, [](const VariantConfig& variant) { return variant.true_poses; });
  if (left_out > 0) progress.say(fmt::format("left out {} variants that need the true poses (--truth)", left_out));
  if (variants.empty()) throw InputError("every variant needs the true poses, expected --truth FILE");
  return variants;
}

void tell_of_relations(const Episode& episode, ProgressLine& progress) {
  if (episode.runs.empty()) return;
  const auto& errors = episode.runs.front().record.scores.relations_final;
  if (errors && errors->unmatched > 0) {
    progress.warn(fmt::format("{} relations name a stamp that no record has: left out", errors->unmatched));
  }
}

int replay(const ReplayArguments& arguments) {
  const Options& options = arguments.options;
  check_out(options);
  ReplayConfig config = load_config(arguments);
  const Recording recording = load_log(arguments.log, config.log);
  const std::optional<TruthLog> truth = load_truth(arguments.truth, recording);
  std::vector<Relation> relations;
  if (!arguments.relations.empty()) relations = read_relations(arguments.relations);
  start_at(recording.start, config.variants);

  ProgressLine progress(0, options.quiet);
  const std::vector<VariantConfig> variants =
      possible_variants(chosen_variants(options, config.variants), truth.has_value(), progress);
  progress.expect(static_cast<int>(variants.size()) + (options.no_files ? 0 : 1));
  Workers workers(options.threads);
  const Episode episode =
      replay_variants(log_name(arguments.log), recording, {.truth = truth ? &*truth : nullptr, .relations = relations},
                      variants, config.seed, workers, progress.begin(), trace_limits(options));
  tell_of_relations(episode, progress);
  const RunFiles files{.episode = episode,
                       .recording = recording,
                       .truth = truth ? &*truth : nullptr,
                       .config_name = arguments.scenario.empty() ? "replay.yaml" : "scenario.yaml",
                       .config = choice_comment(options) + config.resolved,
                       .page = options.page,
                       .save_readings = options.save_readings};
  return publish(files, options, progress);
}

}  // namespace

Command replay_command(CLI::App& program) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* parser = program.add_subcommand("replay", "run filters on a recording of ours or on a CARMEN log");
  parser->add_option("LOG", arguments->log, "readings.bin of a run, or a CARMEN log, plain or .gz")->required();
  CLI::Option* scenario =
      parser->add_option("--scenario", arguments->scenario, "replay through the filters of a scenario")
          ->type_name("FILE");
  parser->add_option("--config", arguments->config, "YAML file with the sections log, map, slam and variants")
      ->type_name("FILE")
      ->excludes(scenario);
  parser
      ->add_option("--area", arguments->area,
                   "what the map covers [m]; without it the map grows, and the store "
                   "coefficients cannot be used")
      ->type_name("X0,Y0,X1,Y1")
      ->excludes(scenario);
  parser->add_option("--truth", arguments->truth, "truth.bin that belongs to the recording: score against it")
      ->type_name("FILE");
  parser->add_option("--relations", arguments->relations, "score against a SLAM-benchmark .relations file")
      ->type_name("FILE");
  add_options(*parser, arguments->options);
  return {parser, [arguments] { return replay(*arguments); }};
}

}  // namespace cogslam
