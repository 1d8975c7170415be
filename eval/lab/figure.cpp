#include "eval/lab/figure.hpp"

#include <fmt/format.h>

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"

namespace cogslam {

LabFigure lab_figure(int number, const FigureConfig& config, Workers& workers, const LabProgress& progress) {
  EXPECTS(number >= kFirstFigure && number <= kLastFigure);
  switch (number) {
    case 1:
      return figure_test_signal();
    case 6:
      return figure_mse_by_p(config, workers, progress);
    case 7:
    case 8: {
      const SignalStudy study = comparison_study(config);
      const std::vector<SignalScore> scores = run_signal_study(study, workers, progress);
      return number == 7 ? figure_mse_by_percent(study, scores) : figure_time_by_percent(study, scores);
    }
    case 9:
      return figure_example_grid();
    case 10:
      return figure_grid_recoveries(config, workers, progress);
    case 11:
      return figure_l2_times(progress);
    default:
      return figure_recoveries(number, config, workers, progress);
  }
}

void write_figure(const std::filesystem::path& folder, int number, const LabFigure& figure) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError({folder.string()}, "cannot be written: " + error.message());
  const std::string stem = fmt::format("figure_{:02}", number);
  write_file(folder / (stem + ".csv"), figure.csv);
  write_file(folder / (stem + ".svg"), chart_svg(figure.sheet));
  write_file(folder / (stem + ".png"), chart_png(figure.sheet));
}

}  // namespace cogslam
