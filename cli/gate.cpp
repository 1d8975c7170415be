#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "core/output_file.hpp"
#include "eval/gate/baseline_file.hpp"
#include "eval/gate/gate_output.hpp"
#include "eval/gate/gate_update.hpp"

namespace cogslam {
namespace {

constexpr const char* kProgram = "cogslam " COGSLAM_VERSION;

struct GateArguments {
  Options options;  ///< of these: settings, threads, json, quiet
  std::filesystem::path gate;
  std::optional<int> seeds;
  std::optional<std::uint32_t> first_seed;
  std::filesystem::path junit;
  bool update = false;
};

/// A gate file with the scenarios that it names, read before anything runs.
struct Plan {
  GateConfig config;
  std::vector<Scenario> scenarios;  ///< as config.scenarios
  std::size_t tests = 0;
  double false_alarm = 0.0;  ///< of each test
};

Plan read_plan(const GateArguments& arguments) {
  Plan plan{.config = load_gate_config(arguments.gate)};
  if (arguments.seeds) plan.config.seeds = *arguments.seeds;
  const Overrides more = overrides_of(arguments.options, {});
  for (const GateScenario& scenario : plan.config.scenarios) {
    plan.scenarios.push_back(load_gate_scenario(scenario, more));
  }
  plan.tests = count_tests(plan.scenarios, plan.config.demands);
  if (plan.tests == 0) throw InputError({arguments.gate.string()}, "no variant has any of the metrics");
  plan.false_alarm = plan.config.false_alarm / static_cast<double>(plan.tests);
  return plan;
}

GateResult judge_scenario(const GateArguments& arguments, const Plan& plan, std::size_t i, Workers& workers,
                          ProgressLine& progress) {
  const GateScenario& gate = plan.config.scenarios[i];
  const std::filesystem::path file = baseline_file(plan.config, gate);
  const std::optional<GateMeasurement> baseline = load_baseline(file);
  GateSeeds seeds{.first = arguments.first_seed.value_or(1), .count = plan.config.seeds};
  if (baseline && !arguments.first_seed) {
    seeds.first = baseline->first_seed + static_cast<std::uint32_t>(baseline->seeds());
  }
  GateResult result{.scenario = gate.name};
  result.problem = why_not_comparable(baseline, plan.scenarios[i], seeds, file.string());
  if (result.problem.empty()) {
    const GateMeasurement now =
        measure(gate.name, plan.scenarios[i], plan.config.demands, seeds, kProgram, workers, progress.begin());
    result = compare(*baseline, now, plan.scenarios[i], plan.config, plan.false_alarm);
  }
  result.baseline_file = file.string();
  return result;
}

int judge(const GateArguments& arguments, const Plan& plan, ProgressLine& progress) {
  Workers workers(arguments.options.threads);
  GateReport report{.gate = arguments.gate.string(),
                    .program = kProgram,
                    .false_alarm = plan.config.false_alarm,
                    .power = plan.config.power,
                    .tests = plan.tests};
  for (std::size_t i = 0; i < plan.scenarios.size(); ++i) {
    report.results.push_back(judge_scenario(arguments, plan, i, workers, progress));
  }
  progress.end_stage();
  progress.clear();
  if (!arguments.junit.empty()) write_file(arguments.junit, gate_junit(report));
  fmt::print("{}", arguments.options.json ? gate_json(report) : gate_table(report));
  switch (report.verdict()) {
    case Verdict::kPass:
      return kOk;
    case Verdict::kFail:
      return kGateFailed;
    case Verdict::kNotMeasured:
      break;
  }
  return kNothingMeasured;
}

bool has_figure(const GateMeasurement& measurement) {
  return std::any_of(measurement.figures.begin(), measurement.figures.end(),
                     [](const GateFigure& figure) { return figure.missing == 0; });
}

/// The old baseline, to show beside the new one; a broken one is replaced all the same.
std::optional<GateMeasurement> readable_baseline(const std::filesystem::path& file) {
  try {
    return load_baseline(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Before minutes are spent on what could not be kept.
void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError({folder.string()}, "baselines cannot be written there");
  }
}

int update(const GateArguments& arguments, const Plan& plan, ProgressLine& progress) {
  make_folder(plan.config.baselines);
  Workers workers(arguments.options.threads);
  int code = kOk;
  for (std::size_t i = 0; i < plan.scenarios.size(); ++i) {
    const GateScenario& gate = plan.config.scenarios[i];
    const std::filesystem::path file = baseline_file(plan.config, gate);
    const GateMeasurement now =
        measure(gate.name, plan.scenarios[i], plan.config.demands, {.first = 1, .count = plan.config.baseline_seeds},
                kProgram, workers, progress.begin());
    progress.end_stage();
    progress.clear();
    if (!has_figure(now)) {
      progress.warn(gate.name + ": nothing measured, " + file.string() + " not written");
      code = kNothingMeasured;
      continue;
    }
    fmt::print("{}", update_table(readable_baseline(file), now, plan.scenarios[i], plan.config, plan.false_alarm));
    write_file(file, baseline_text(now));
    progress.say("wrote " + file.string());
  }
  return code;
}

int run(const GateArguments& arguments) {
  const Plan plan = read_plan(arguments);
  const int seeds = arguments.update ? plan.config.baseline_seeds : plan.config.seeds;
  ProgressLine progress(seeds * static_cast<int>(plan.scenarios.size()), arguments.options.quiet);
  return arguments.update ? update(arguments, plan, progress) : judge(arguments, plan, progress);
}

}  // namespace

Command gate_command(CLI::App& program) {
  auto arguments = std::make_shared<GateArguments>();
  CLI::App* parser = program.add_subcommand("gate", "hold the scores of scenarios against their committed baselines");
  parser->footer(
      "Exit codes: 0 all passed, 1 a figure is worse or has no baseline, 4 a figure was not measured or the seeds "
      "cannot tell.");
  parser->add_option("GATE", arguments->gate, "gate file (YAML): scenarios, metrics, limits")->required();
  auto* update = parser->add_flag("--update", arguments->update, "measure the baselines anew and write them");
  parser->add_option("--seeds", arguments->seeds, "how many seeds to run, in place of the file's")
      ->check(CLI::Range(2, 10000))
      ->excludes(update);
  parser
      ->add_option("--first-seed", arguments->first_seed,
                   "first seed to run; default: the one after the baseline's. Seeds of the baseline are compared in "
                   "pairs")
      ->excludes(update);
  add_set_option(*parser, arguments->options)->excludes(update);
  add_threads_option(*parser, arguments->options);
  parser->add_flag("--json", arguments->options.json, "print one JSON object in place of the table")->excludes(update);
  parser->add_option("--junit", arguments->junit, "also write the verdicts as JUnit XML")
      ->type_name("FILE")
      ->excludes(update);
  parser->add_flag("--quiet", arguments->options.quiet, "no progress and no notes");
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
