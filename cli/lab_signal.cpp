#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/lab.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "core/output_file.hpp"
#include "eval/lab/figure.hpp"

namespace cogslam {
namespace {

struct SignalArguments {
  LabOptions options;
  std::vector<std::string> methods;
  std::filesystem::path out;
  bool csv = false;
};

void write_files(const std::filesystem::path& folder, const SignalStudy& study,
                 const std::vector<SignalScore>& scores) {
  write_figure(folder, 7, figure_mse_by_percent(study, scores));
  write_figure(folder, 8, figure_time_by_percent(study, scores));
}

int run(const SignalArguments& arguments) {
  const SignalStudy study{
      .methods = lab_methods_named(arguments.methods), .percents = twenty_percents(), .seeds = arguments.options.seeds};
  if (!arguments.out.empty()) check_out_folder(arguments.out);
  ProgressLine progress(1, arguments.options.quiet);
  Workers workers(arguments.options.threads);
  const std::vector<SignalScore> scores =
      run_signal_study(study, workers, progress.begin()(fmt::format("{} seeds", study.seeds)));
  progress.end_stage();
  progress.clear();
  if (!arguments.out.empty()) write_files(arguments.out, study, scores);
  fmt::print("{}", arguments.csv ? signal_csv(study, scores) : signal_table(study, scores));
  return kOk;
}

}  // namespace

Command lab_signal_command(CLI::App& lab) {
  auto arguments = std::make_shared<SignalArguments>();
  CLI::App* parser = lab.add_subcommand("signal", "the signal of eq. (24) at 5, 10, ..., 100 % of its data");
  parser->add_option("--method", arguments->methods, "a recovery, may be repeated; all where none is named");
  parser->add_option("--seeds", arguments->options.seeds, "random compression matrices; an interval needs two")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  parser->add_flag("--csv", arguments->csv, "print the mean errors as CSV, in place of the table");
  parser->add_option("--out", arguments->out, "folder for the plots of error and time (figures 7 and 8)");
  add_lab_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
