#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/lab.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "eval/lab/figure.hpp"

namespace cogslam {
namespace {

struct FiguresArguments {
  LabOptions options;
  std::vector<int> numbers;
  std::filesystem::path out = "figures";
};

std::vector<int> chosen(const FiguresArguments& arguments) {
  if (!arguments.numbers.empty()) return arguments.numbers;
  std::vector<int> all;
  for (int number = kFirstFigure; number <= kLastFigure; ++number) all.push_back(number);
  return all;
}

int run(const FiguresArguments& arguments) {
  const std::vector<int> numbers = chosen(arguments);
  check_out_folder(arguments.out);
  ProgressLine progress(static_cast<int>(numbers.size()), arguments.options.quiet);
  const StageBegin begin = progress.begin();
  Workers workers(arguments.options.threads);
  const FigureConfig config{.seeds = arguments.options.seeds};
  const SignalStudy comparison = comparison_study(config);
  std::vector<SignalScore> compared;  // behind both figures 7 and 8
  for (const int number : numbers) {
    const Progress report = begin(fmt::format("figure {}", number));
    if (number == 7 || number == 8) {
      if (compared.empty()) compared = run_signal_study(comparison, workers, report);
      write_figure(
          arguments.out, number,
          number == 7 ? figure_mse_by_percent(comparison, compared) : figure_time_by_percent(comparison, compared));
    } else {
      write_figure(arguments.out, number, lab_figure(number, config, workers, report));
    }
  }
  progress.end_stage();
  progress.clear();
  fmt::print("{}\n", arguments.out.string());
  return kOk;
}

}  // namespace

Command lab_figures_command(CLI::App& lab) {
  auto arguments = std::make_shared<FiguresArguments>();
  CLI::App* parser = lab.add_subcommand("figures", "figures 1 to 11 of the paper as CSV, SVG and PNG");
  parser->add_option("NUMBER", arguments->numbers, "1 to 11; all where none is given")
      ->check(CLI::Range(kFirstFigure, kLastFigure));
  parser->add_option("--seeds", arguments->options.seeds, "random compression matrices; an interval needs two")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  parser->add_option("--out", arguments->out, "folder")->type_name("DIR")->capture_default_str();
  add_lab_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
