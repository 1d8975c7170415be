// Figures 1 to 5: the test signal, and what each recovery makes of it.
#include <fmt/format.h>

#include "core/check.hpp"
#include "eval/lab/figure.hpp"
#include "eval/lab/test_signal.hpp"

namespace cogslam {
namespace {

constexpr std::uint32_t kShownSeed = 1;
constexpr double kShownPercents[] = {25.0, 50.0, 75.0, 95.0};

std::vector<std::string> methods_of_figure(int number) {
  switch (number) {
    case 2:
      return {"fast_l2"};
    case 3:
      return {"nesta"};
    case 4:
      return {"csekf"};
    default:
      EXPECTS(number == 5);
      return {"csekf_p_printed", "csekf_p_gradient", "csekf_p_power"};
  }
}

std::string mse_text(const SignalScore& score) {
  const MeanInterval mse = mean_interval(score.mse);
  return fmt::format("MSE {:.2g} +- {:.1g}", mse.mean, mse.half_width);
}

/// The recoveries at one percentage over the true signal.
Chart recovery_chart(const SignalStudy& study, const std::vector<SignalScore>& scores, double percent,
                     std::string& csv) {
  const std::vector<double> t = test_signal_times(), truth = test_signal();
  Chart chart{.title = fmt::format("{} % of the data", percent),
              .x = {.label = "t", .min = 0.0, .max = 10.0},
              .y = {.label = "f(t)", .min = -6.0, .max = 4.0},
              .series = {{.name = "f(t)", .x = t, .y = truth, .style = SeriesStyle::kLineOnly, .look = 0}}};
  for (const SignalScore& score : scores) {
    if (score.percent != percent) continue;
    const LabMethod& method = study.methods[score.method];
    const std::vector<double> x = recovered_signal(method, percent, kShownSeed);
    for (std::size_t i = 0; i < x.size(); ++i) {
      csv += fmt::format("{},{},{},{},{}\n", method.name, percent, t[i], truth[i], x[i]);
    }
    chart.series.push_back({.name = method.label + ": " + mse_text(score),
                            .x = t,
                            .y = x,
                            .style = SeriesStyle::kLineOnly,
                            .look = static_cast<int>(score.method) + 1});
  }
  return chart;
}

}  // namespace

LabFigure figure_test_signal() {
  const std::vector<double> t = test_signal_times(), x = test_signal(), c = test_signal_coefficients();
  LabFigure figure{.csv = "index,t,f,coefficient\n",
                   .sheet = {.heading = "Figure 1: the test signal, eq. (24), and its coefficients", .columns = 2}};
  std::vector<double> index;
  for (std::size_t i = 0; i < t.size(); ++i) {
    index.push_back(static_cast<double>(i));
    figure.csv += fmt::format("{},{},{},{}\n", i, t[i], x[i], c[i]);
  }
  figure.sheet.charts = {{.title = "(a) f(t) = sin t - cos 2t - 3 sin t/4",
                          .x = {.label = "t"},
                          .y = {.label = "f(t)"},
                          .series = {{.x = t, .y = x, .style = SeriesStyle::kLineOnly}}},
                         {.title = "(b) orthonormal DCT-II",
                          .x = {.label = "coefficient"},
                          .y = {.label = "value"},
                          .series = {{.x = index, .y = c, .style = SeriesStyle::kStems, .look = 1}}}};
  return figure;
}

LabFigure figure_recoveries(int number, const FigureConfig& config, Workers& workers, const LabProgress& progress) {
  const SignalStudy study{.methods = lab_methods_named(methods_of_figure(number)),
                          .percents = {std::begin(kShownPercents), std::end(kShownPercents)},
                          .seeds = config.seeds};
  const std::vector<SignalScore> scores = run_signal_study(study, workers, progress);
  const char* names[] = {"l2 recovery", "CS recovery by NESTA", "CSEKF", "CSEKF-p, p = 0.4"};
  LabFigure figure{.csv = "method,percent,t,f,recovered\n",
                   .sheet = {.heading = fmt::format("Figure {}: {}", number, names[number - 2]),
                             .columns = 2,
                             .note = fmt::format("curves: seed {}; MSE: mean over {} seeds with 95 % interval",
                                                 kShownSeed, config.seeds)}};
  for (const double percent : kShownPercents) {
    figure.sheet.charts.push_back(recovery_chart(study, scores, percent, figure.csv));
  }
  return figure;
}

}  // namespace cogslam
