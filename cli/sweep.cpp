#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "eval/sweep/engine.hpp"
#include "eval/sweep/episode_job.hpp"
#include "eval/sweep/summary.hpp"
#include "eval/sweep/sweep.hpp"

namespace cogslam {
namespace {

struct SweepArguments {
  std::filesystem::path file;
  std::filesystem::path out;
  int workers = 1;
  bool fail_fast = false;
  bool keep_going = false;
  bool quiet = false;
};

void tell_of_start(const Sweep& sweep, std::size_t missing, ProgressLine& progress) {
  const std::size_t planned = sweep.plan().episodes.size();
  progress.say(fmt::format("{}: {} episodes, {} there, {} to measure, in {}", sweep.plan().name, planned,
                           planned - missing, missing, sweep.folder().root.string()));
  if (const std::size_t others = sweep.of_other_builds(); others > 0) {
    progress.warn(
        fmt::format("{} of the episodes there were measured by another build of this program; "
                    "for rows of this one alone use another --out",
                    others));
  }
}

void measure(Sweep& sweep, const std::vector<const PlannedEpisode*>& missing, const SweepArguments& arguments,
             ProgressLine& progress) {
  if (missing.empty()) return;
  std::size_t ended = 0;
  const std::string title = fmt::format("{} episodes", missing.size());
  Progress report = progress.begin()(title);
  const EpisodeEnd end = [&](const PlannedEpisode& episode, const std::string& error) {
    ++ended;
    if (error.empty() && sweep.take_in(episode)) return;
    const std::string reason = error.empty() ? "its result cannot be read" : error;
    sweep.note_failure(episode, reason);
    progress.warn(fmt::format("{} {} m, {}, seed {}: {} (see {})", episode.variant, episode.cell_size, episode.world,
                              episode.seed, reason, sweep.folder().episode(episode.key, ".log").string()));
    report = progress.begin()(title);
  };
  const auto tick = [&] { report(static_cast<double>(ended) / static_cast<double>(missing.size())); };
  run_locally(sweep.folder(), missing,
              {.program = "/proc/self/exe", .workers = arguments.workers, .fail_fast = arguments.fail_fast}, end, tick);
  progress.end_stage();
}

int conclude(const Sweep& sweep, ProgressLine& progress) {
  const EpisodeTable table = sweep.results();
  sweep.export_results();
  progress.clear();
  if (!table.rows.empty()) fmt::print("{}", summary_table(summarize(table)));
  const auto failures = sweep.failures();
  if (table.rows.size() == sweep.plan().episodes.size()) return kOk;
  const bool nothing_to_measure = std::all_of(failures.begin(), failures.end(),
                                              [](const auto& failure) { return failure.second == kNothingToMeasure; });
  progress.warn(fmt::format("{} of {} episodes have no result", sweep.plan().episodes.size() - table.rows.size(),
                            sweep.plan().episodes.size()));
  return nothing_to_measure && !failures.empty() && table.rows.empty() ? kNothingMeasured : kRunFailed;
}

int sweep(const SweepArguments& arguments) {
  SweepPlan plan = load_sweep(arguments.file);
  const std::filesystem::path out = arguments.out.empty() ? std::filesystem::path("sweeps") / plan.name : arguments.out;
  ProgressLine progress(1, arguments.quiet);
  Sweep sweep(std::move(plan), {out});
  const std::vector<const PlannedEpisode*> missing = sweep.missing();
  tell_of_start(sweep, missing.size(), progress);
  try {
    measure(sweep, missing, arguments, progress);
  } catch (const Interrupted&) {
    progress.warn(fmt::format("interrupted; {} of {} episodes are kept: run again to go on",
                              sweep.results().rows.size(), sweep.plan().episodes.size()));
    return kInterrupted;
  }
  return conclude(sweep, progress);
}

}  // namespace

Command sweep_command(CLI::App& program) {
  auto arguments = std::make_shared<SweepArguments>();
  CLI::App* parser = program.add_subcommand("sweep", "run many variants on many worlds and seeds, and compare them");
  parser->add_option("FILE", arguments->file, "sweep file (YAML)")->required();
  parser->add_option("-o,--out", arguments->out, "folder for the results; a sweep that is there is gone on with")
      ->type_name("FOLDER");
  arguments->workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  parser->add_option("-j,--workers", arguments->workers, "episodes at a time; the scores do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  CLI::Option* fail_fast =
      parser->add_flag("--fail-fast", arguments->fail_fast, "stop at the first episode that fails");
  parser->add_flag("--keep-going", arguments->keep_going, "measure what can be measured; this is the default")
      ->excludes(fail_fast);
  parser->add_flag("--quiet", arguments->quiet, "no progress on standard error");
  return {parser, [arguments] { return sweep(*arguments); }};
}

}  // namespace cogslam
