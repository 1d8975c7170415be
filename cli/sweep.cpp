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
  std::string engine = "local";
  SlurmConfig slurm{};
  bool dry_run = false;
  int workers = 1;
  bool fail_fast = false;
  bool keep_going = false;
  bool quiet = false;
};

/// Where this program lies, for workers of this machine and of others.
std::filesystem::path this_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

void add_slurm_options(CLI::App& parser, SlurmConfig& slurm) {
  slurm.program = this_program();
  const char* group = "With --engine slurm";
  parser.add_option("--partition", slurm.partition, "passed on to sbatch")->group(group);
  parser.add_option("--time", slurm.time, "limit of a task, passed on to sbatch")->group(group);
  parser.add_option("--account", slurm.account, "passed on to sbatch")->group(group);
  parser.add_option("--chunk", slurm.chunk, "episodes per task, at most")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->group(group);
  parser.add_option("--rounds", slurm.rounds, "submit what is missing at most so often")
      ->check(CLI::Range(1, 100))
      ->capture_default_str()
      ->group(group);
  parser.add_option("--poll-ms", slurm.poll_ms, "between two looks at the queue")
      ->check(CLI::Range(100, 3600000))
      ->capture_default_str()
      ->group(group);
}

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
  const Progress report = progress.begin()(title);
  const EpisodeEnd end = [&](const PlannedEpisode& episode, const std::string& error) {
    ++ended;
    if (error.empty() && sweep.take_in(episode)) return;
    const std::string reason = error.empty() ? "its result cannot be read" : error;
    sweep.note_failure(episode, reason);
    progress.warn_amid(fmt::format("{} {} m, {}, seed {}: {} (see {})", episode.variant, episode.cell_size,
                                   episode.world, episode.seed, reason,
                                   sweep.folder().episode(episode.key, ".log").string()));
  };
  const auto tick = [&] { report(static_cast<double>(ended) / static_cast<double>(missing.size())); };
  if (arguments.engine == "slurm") {
    run_on_slurm(sweep.plan().name, sweep.folder(), missing, arguments.slurm, end, tick);
  } else {
    run_locally(sweep.folder(), missing,
                {.program = this_program(), .workers = arguments.workers, .fail_fast = arguments.fail_fast}, end, tick);
  }
  progress.end_stage();
}

/// What would be done in an empty folder.
int print_plan(const SweepPlan& plan, const SweepFolder& folder, const SweepArguments& arguments) {
  if (arguments.engine == "slurm") {
    std::vector<const PlannedEpisode*> episodes;
    for (const PlannedEpisode& episode : plan.episodes) episodes.push_back(&episode);
    const std::size_t tasks = slurm_tasks(episodes, arguments.slurm.chunk).size();
    fmt::print("{}", slurm_script(plan.name, tasks, next_slurm_lists(folder), folder, arguments.slurm));
    return kOk;
  }
  for (const PlannedEpisode& episode : plan.episodes) {
    fmt::print("{} {} {} m {} seed {}\n", episode.key, episode.world, episode.cell_size, episode.variant, episode.seed);
  }
  return kOk;
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
  const SweepFolder folder{
      std::filesystem::absolute(arguments.out.empty() ? std::filesystem::path("sweeps") / plan.name : arguments.out)};
  if (arguments.dry_run) return print_plan(plan, folder, arguments);
  ProgressLine progress(1, arguments.quiet);
  Sweep sweep(std::move(plan), folder);
  const std::vector<const PlannedEpisode*> missing = sweep.missing();
  tell_of_start(sweep, missing.size(), progress);
  try {
    measure(sweep, missing, arguments, progress);
  } catch (const Interrupted&) {
    progress.warn(fmt::format("interrupted; {} of {} episodes are kept: run again to go on",
                              sweep.results().rows.size(), sweep.plan().episodes.size()));
    return kInterrupted;
  } catch (const InputError& error) {  // of a file that the sweep itself writes: the user's files were right
    throw std::runtime_error(error.what());
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
      ->take_last()
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  parser->add_option("--engine", arguments->engine, "local: processes of this machine; slurm: job arrays")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  add_slurm_options(*parser, arguments->slurm);
  parser->add_flag("--dry-run", arguments->dry_run, "print the script for Slurm, or the list of episodes, and stop");
  CLI::Option* fail_fast =
      parser->add_flag("--fail-fast", arguments->fail_fast, "stop at the first episode that fails");
  parser->add_flag("--keep-going", arguments->keep_going, "measure what can be measured; this is the default")
      ->excludes(fail_fast);
  parser->add_flag("--quiet", arguments->quiet, "no progress on standard error");
  return {parser, [arguments] { return sweep(*arguments); }};
}

}  // namespace cogslam
