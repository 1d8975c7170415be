#include "cli/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <thread>

#include "cli/exit_codes.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/sweep/engine.hpp"
#include "eval/sweep/sweep.hpp"

namespace cogslam {
namespace {

struct FiguresArguments {
  std::vector<std::string> names;
  std::filesystem::path files = "scenarios/sweeps";
  std::filesystem::path sweeps = "sweeps";
  std::filesystem::path out = "figures";
  std::optional<std::size_t> seeds;
  int workers = 1;
  bool only_draw = false;
  bool quiet = false;
};

std::vector<const ExperimentFigure*> chosen(const FiguresArguments& arguments) {
  std::vector<const ExperimentFigure*> figures;
  for (const std::string& name : arguments.names) figures.push_back(&experiment_figure(name));
  if (!figures.empty()) return figures;
  for (const ExperimentFigure& figure : experiment_figures()) {
    if (!figure.asked_only) figures.push_back(&figure);
  }
  return figures;
}

/// Runs the episodes that have no row yet; the first that fails ends it.
void measure(Sweep& sweep, const std::vector<const PlannedEpisode*>& missing, int workers, ProgressLine& progress) {
  std::size_t ended = 0;
  const std::string title = fmt::format("sweep {}, {} episodes", sweep.plan().name, missing.size());
  const Progress report = progress.begin()(title);
  const EpisodeEnd end = [&](const PlannedEpisode& episode, const std::string& error) {
    ++ended;
    if (error.empty() && sweep.take_in(episode)) return;
    sweep.note_failure(episode, error);
    throw std::runtime_error(fmt::format("{}, seed {}: {} (see {})", episode.variant, episode.seed, error,
                                         sweep.folder().episode(episode.key, ".log").string()));
  };
  const auto tick = [&] { report(static_cast<double>(ended) / static_cast<double>(missing.size())); };
  run_locally(sweep.folder(), missing, {.program = "/proc/self/exe", .workers = workers, .fail_fast = true}, end, tick);
  progress.end_stage();
}

std::filesystem::path folder_of(const FiguresArguments& arguments, const std::string& name) {
  return arguments.sweeps / name;
}

void keep_first_seeds(std::size_t count, SweepPlan& plan) {
  std::set<std::uint32_t> seeds;
  for (const PlannedEpisode& episode : plan.episodes) seeds.insert(episode.seed);
  if (seeds.size() < count) {
    throw InputError(
        fmt::format("--seeds {}: sweep {} has {} seeds, expected at most that many", count, plan.name, seeds.size()));
  }
  std::erase_if(plan.episodes, [last = *std::next(seeds.begin(), static_cast<std::ptrdiff_t>(count) - 1)](
                                   const PlannedEpisode& episode) { return episode.seed > last; });
}

/// To draw alone the table must be there and whole: this says how it comes about.
MeasuredSweep found_sweep(SweepPlan plan, SweepFolder folder, const std::filesystem::path& file) {
  const std::string remedy = fmt::format("run `cogslam sweep {} --out {}`", file.string(), folder.root.string());
  if (!std::filesystem::exists(folder.database())) {
    throw InputError({folder.database().string()}, "not there: " + remedy);
  }
  EpisodeTable table = SweepDatabase::open_to_read(folder.database()).results();
  if (table.rows.size() < plan.episodes.size()) {
    throw InputError({folder.database().string()},
                     fmt::format("holds {} of {} episodes: {}", table.rows.size(), plan.episodes.size(), remedy));
  }
  return {std::move(plan), std::move(folder), std::move(table)};
}

MeasuredSweep measured_sweep(const std::string& name, const FiguresArguments& arguments, ProgressLine& progress) {
  const std::filesystem::path file = arguments.files / (name + ".yaml");
  SweepPlan plan = load_sweep(file);
  if (arguments.seeds) keep_first_seeds(*arguments.seeds, plan);
  const SweepFolder folder{folder_of(arguments, name)};
  if (arguments.only_draw) return found_sweep(std::move(plan), folder, file);
  Sweep sweep(std::move(plan), folder);
  if (const auto missing = sweep.missing(); !missing.empty()) measure(sweep, missing, arguments.workers, progress);
  sweep.export_results();
  return {sweep.plan(), sweep.folder(), sweep.results()};
}

int run(const FiguresArguments& arguments) {
  const std::vector<const ExperimentFigure*> figures = chosen(arguments);
  ProgressLine progress(static_cast<int>(figures.size()), arguments.quiet);
  Workers workers(arguments.workers);
  std::map<std::string, MeasuredSweep> sweeps;
  for (const ExperimentFigure* figure : figures) {
    for (const std::string& name : figure->sweeps) {
      if (!sweeps.contains(name)) sweeps.emplace(name, measured_sweep(name, arguments, progress));
    }
    const Progress report = progress.begin()(fmt::format("figure {}: {}", figure->name, figure->shows));
    write_experiment_figure(arguments.out, *figure,
                            figure->make({.sweeps = sweeps, .workers = workers, .progress = report}));
  }
  progress.end_stage();
  progress.clear();
  fmt::print("{}\n", arguments.out.string());
  return kOk;
}

std::string all_figures() {
  std::string text = "Figures:";
  for (const ExperimentFigure& figure : experiment_figures()) {
    text += fmt::format("\n  {:9}  {}{}", figure.name, figure.shows, figure.asked_only ? " (long: only by name)" : "");
  }
  return text + "\nEach runs the sweeps that it is drawn from, where their episodes are not there yet.";
}

void add_figures_options(CLI::App& parser, FiguresArguments& arguments) {
  parser.add_option("NAME", arguments.names, "as listed below; all where none is given");
  parser.add_option("--files", arguments.files, "folder of the sweep files")->type_name("DIR")->capture_default_str();
  parser.add_option("--sweeps", arguments.sweeps, "folder of the sweeps' results, as `cogslam sweep` makes it")
      ->type_name("DIR")
      ->capture_default_str();
  parser.add_option("--out", arguments.out, "folder of the figures")->type_name("DIR")->capture_default_str();
  parser.add_option("--seeds", arguments.seeds, "only the first drives of those that the sweep files state")
      ->check(CLI::Range(1, 100000));
  arguments.workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  parser.add_option("-j,--workers", arguments.workers, "episodes at a time; the scores do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  parser.add_flag("--only-draw", arguments.only_draw, "run no sweep: say which command makes what is missing");
  parser.add_flag("--quiet", arguments.quiet, "no progress on standard error");
}

}  // namespace

Command figures_command(CLI::App& program) {
  auto arguments = std::make_shared<FiguresArguments>();
  CLI::App* parser = program.add_subcommand("figures", "figures 12 to 24 of the paper and what it lacks, from sweeps");
  add_figures_options(*parser, *arguments);
  parser->footer(all_figures());
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
