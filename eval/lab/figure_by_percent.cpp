// Figures 7 and 8: error and time of every recovery over the percentage of data.
#include <fmt/format.h>

#include <algorithm>

#include "eval/lab/figure.hpp"

namespace cogslam {
namespace {

Series curve(const std::string& name, const SignalScore* scores, std::size_t count, bool times, double unit) {
  Series series{.name = name};
  for (std::size_t i = 0; i < count; ++i) {
    const MeanInterval value = mean_interval(times ? scores[i].cpu_seconds : scores[i].mse);
    series.x.push_back(scores[i].percent);
    series.y.push_back(value.mean / unit);
    series.low.push_back(value.low() / unit);
    series.high.push_back(value.high() / unit);
  }
  return series;
}

std::vector<Series> curves(const SignalStudy& study, const std::vector<SignalScore>& scores, bool times, double unit) {
  std::vector<Series> all;
  const std::size_t count = study.percents.size();
  for (std::size_t i = 0; i < study.methods.size(); ++i) {
    all.push_back(curve(study.methods[i].label, &scores[i * count], count, times, unit));
    all.back().look = static_cast<int>(i);
  }
  return all;
}

}  // namespace

SignalStudy comparison_study(const FigureConfig& config) {
  return {.methods = lab_methods(), .percents = twenty_percents(), .seeds = config.seeds};
}

LabFigure figure_mse_by_percent(const SignalStudy& study, const std::vector<SignalScore>& scores) {
  LabFigure figure{.csv = signal_csv(study, scores),
                   .sheet = {.heading = "Figure 7: error of each recovery over the data kept",
                             .columns = 2,
                             .note = fmt::format("mean over {} seeds with 95 % interval; l2 by pinv equals l2 by H' y",
                                                 study.seeds)}};
  std::vector<Series> series = curves(study, scores, false, 1.0);
  std::erase_if(series, [](const Series& s) { return s.name.find("pinv") != std::string::npos; });
  const ChartAxis x{.label = "% of the data", .min = 0.0, .max = 100.0};
  Chart linear;
  linear.title = "(a) as the paper: linear";
  linear.x = x;
  linear.y = {.label = "MSE", .min = 0.0, .max = 8.0};
  linear.series = series;
  Chart logarithmic = linear;
  logarithmic.title = "(b) logarithmic";
  logarithmic.y = {.label = "MSE", .log = true, .min = 1e-9, .max = 1e3};
  figure.sheet.charts.push_back(linear);
  figure.sheet.charts.push_back(logarithmic);
  return figure;
}

LabFigure figure_time_by_percent(const SignalStudy& study, const std::vector<SignalScore>& scores) {
  // The unit: l2 by singular values from all the data, in this run. Machines and loads cancel out.
  double unit = 0.0;
  for (const SignalScore& s : scores) {
    if (study.methods[s.method].name == "pinv") unit = mean_interval(s.cpu_seconds).mean;
  }
  const bool relative = unit > 0.0;
  if (!relative) unit = 1e-3;  // pinv was not among the methods
  LabFigure figure{.csv = signal_times_csv(study, scores),
                   .sheet = {.heading = "Figure 8: CPU time of each recovery over the data kept",
                             .note = (relative ? fmt::format("1 is {:.3g} ms here; ", 1e3 * unit) : "") +
                                     fmt::format("mean of {} seeds, 95 % band", study.seeds)}};
  const std::string label = relative ? "CPU time / that of l2 by pinv at 100 %" : "CPU time [ms]";
  figure.sheet.charts = {{.x = {.label = "% of the data", .min = 0.0, .max = 100.0},
                          .y = {.label = label, .log = true},
                          .series = curves(study, scores, true, unit)}};
  return figure;
}

}  // namespace cogslam
