#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_codes.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/sense.hpp"
#include "eval/sense/figure.hpp"

namespace cogslam {
namespace {

struct FiguresArguments {
  SenseOptions options;
  std::vector<int> numbers;
  std::string map;
  SenseFigureConfig config;
  std::filesystem::path out = "figures_sense";
};

std::vector<const SenseFigure*> chosen(const FiguresArguments& arguments) {
  std::vector<const SenseFigure*> figures;
  for (const int number : arguments.numbers) figures.push_back(&sense_figure(number));
  if (!figures.empty()) return figures;
  for (const SenseFigure& figure : sense_figures()) figures.push_back(&figure);
  return figures;
}

int run(FiguresArguments& arguments) {
  const std::vector<const SenseFigure*> figures = chosen(arguments);
  if (!arguments.map.empty()) arguments.config.map = read_field_map(arguments.map);
  check_out_folder(arguments.out);
  ProgressLine progress(static_cast<int>(figures.size()), arguments.options.quiet);
  const StageBegin begin = progress.begin();
  Workers workers(arguments.options.threads);
  for (const SenseFigure* figure : figures) {
    const Progress report = begin(fmt::format("figure {}: {}", figure->number, figure->shows));
    write_figure(arguments.out, figure->number, figure->make(arguments.config, workers, report));
  }
  progress.end_stage();
  progress.clear();
  fmt::print("{}\n", arguments.out.string());
  return kOk;
}

std::string all_figures() {
  std::string text = "Figures:";
  for (const SenseFigure& figure : sense_figures()) text += fmt::format("\n  {}  {}", figure.number, figure.shows);
  return text;
}

}  // namespace

Command sense_figures_command(CLI::App& sense) {
  auto arguments = std::make_shared<FiguresArguments>();
  CLI::App* parser = sense.add_subcommand("figures", "figures of the paper as CSV, SVG and PNG");
  parser->add_option("NUMBER", arguments->numbers, "as listed below; all where none is given");
  parser
      ->add_option("--map", arguments->map,
                   fmt::format("field of figures 5 and 6 in place of the hallway: {}", kFieldMapFiles))
      ->type_name("FILE");
  parser->add_option("--seeds", arguments->config.seeds, "draws of cells behind every mean")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  parser->add_option("--out", arguments->out, "folder")->type_name("DIR")->capture_default_str();
  parser->footer(all_figures());
  add_sense_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
