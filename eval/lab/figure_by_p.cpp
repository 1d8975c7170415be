// Figure 6: the error of CSEKF-p over p, at 75 % of the data.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "eval/lab/figure.hpp"

namespace cogslam {
namespace {

using Reading = KalmanCsP::Reading;

constexpr double kPercent = 75.0;
constexpr Reading kReadings[] = {Reading::kAsPrinted, Reading::kTrueGradient, Reading::kPowerSum};

/// "20 equally spaced values of p in (0, 1)" can be 0.05 k (where 1 is left out) or k / 21: both.
std::vector<double> values_of_p() {
  std::set<double> values;
  for (int k = 1; k <= 19; ++k) values.insert(k / 20.0);
  for (int k = 1; k <= 20; ++k) values.insert(k / 21.0);
  return {values.begin(), values.end()};
}

Series series_of(const std::string& name, const std::vector<double>& p, const SignalScore* scores) {
  Series series{.name = name};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const MeanInterval mse = mean_interval(scores[i].mse);
    series.x.push_back(p[i]);
    series.y.push_back(mse.mean);
    series.low.push_back(mse.low());
    series.high.push_back(mse.high());
  }
  return series;
}

}  // namespace

LabFigure figure_mse_by_p(const FigureConfig& config, Workers& workers, const LabProgress& progress) {
  const std::vector<double> p = values_of_p();
  SignalStudy study{.methods = {}, .percents = {kPercent}, .seeds = config.seeds};
  for (const Reading reading : kReadings) {
    for (const double value : p) study.methods.push_back(csekf_p_method(reading, value));
  }
  for (const LabMethod& method : lab_methods_named({"fast_l2"})) study.methods.push_back(method);
  const std::vector<SignalScore> scores = run_signal_study(study, workers, progress);

  LabFigure figure{.csv = "method,p,percent,seeds,mse_mean,mse_low95,mse_high95\n",
                   .sheet = {.heading = "Figure 6: CSEKF-p over p, at 75 % of the data",
                             .note = fmt::format("mean of {} seeds, 95 % band; cut off above 1e4", config.seeds)}};
  Chart chart{.x = {.label = "p", .min = 0.0, .max = 1.0}, .y = {.label = "MSE", .log = true, .min = 1e-5, .max = 1e4}};
  for (std::size_t r = 0; r < std::size(kReadings); ++r) {
    chart.series.push_back(series_of(study.methods[r * p.size()].label, p, &scores[r * p.size()]));
  }
  const double l2 = mean_interval(scores.back().mse).mean;
  chart.series.push_back({.name = "l2", .x = {0.0, 1.0}, .y = {l2, l2}, .style = SeriesStyle::kLineOnly, .look = 0});
  for (std::size_t r = 0; r < 3; ++r) chart.series[r].look = static_cast<int>(r) + 1;
  for (std::size_t i = 0; i + 1 < scores.size(); ++i) {
    const MeanInterval mse = mean_interval(scores[i].mse);
    figure.csv += fmt::format("{},{},{},{},{},{},{}\n", study.methods[i].name, p[i % p.size()], kPercent, mse.count,
                              mse.mean, mse.low(), mse.high());
  }
  figure.sheet.charts = {chart};
  return figure;
}

}  // namespace cogslam
