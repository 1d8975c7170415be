#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "eval/sense/figure.hpp"
#include "eval/sense/recovery_study.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kFigure6Count = 8000;
constexpr double kShades = 200.0;  // steps of grey: equal ones in a row are one rectangle of the picture

/// Counts of the paper that the field has cells for, largest first, as figure 5 has them.
std::vector<std::size_t> paper_counts(const FieldMap& map) {
  std::vector<std::size_t> counts{8000, 3000, 1500, 600};
  std::erase_if(counts, [&](std::size_t k) { return k > map.cells.size(); });
  return counts.empty() ? std::vector<std::size_t>{std::max<std::size_t>(map.cells.size() / 5, 1)} : counts;
}

Chart picture_of(const FieldMap& map, const std::vector<double>& field, const std::string& title,
                 const std::string& label) {
  Grid<float> image({.width = map.width, .height = map.height});
  for (std::size_t i = 0; i < field.size(); ++i) {
    image.values()[i] = static_cast<float>(std::round(kShades * std::clamp(field[i], 0.0, 1.0)) / kShades);
  }
  return {.title = title,
          .x = {.label = label},
          .y = {},
          .series = {},
          .image = ChartImage{.values = std::move(image), .y_down = true}};
}

/// The recovery of the first seed, and how good it is.
Chart recovered_picture(const FieldMap& map, CellChoice choice, FieldPrior prior, std::size_t count,
                        const std::string& title) {
  const std::vector<double> field = recover_field({.prior = prior}, sense_map(map, choice, count, 1)).field;
  return picture_of(map, field, title, quality_line(map_quality(map.cells, field)));
}

Series series_of(const std::vector<RecoveryScore>& scores, const RecoveryScore& like, double MapQuality::*value,
                 const std::string& name) {
  Series series{.name = name, .x = {}, .y = {}};
  for (const RecoveryScore& score : scores) {
    if (score.choice != like.choice || score.prior != like.prior) continue;
    const MeanInterval mean = score.mean(value);
    series.x.push_back(100.0 * static_cast<double>(score.count) / static_cast<double>(score.cells));
    series.y.push_back(mean.mean);
    series.low.push_back(mean.low());
    series.high.push_back(mean.high());
  }
  return series;
}

/// A curve per choice of cells and prior.
Chart curves(const std::vector<RecoveryScore>& scores, double MapQuality::*value, const std::string& title,
             const std::string& label) {
  Chart chart{.title = title, .x = {.label = "K / N [%]", .min = 0.0}, .y = {.label = label, .min = 0.0}, .series = {}};
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const bool first = i == 0 || scores[i].choice != scores[i - 1].choice || scores[i].prior != scores[i - 1].prior;
    if (!first) continue;
    const std::string name = fmt::format("{}, {} cells", name_of(scores[i].prior), name_of(scores[i].choice));
    chart.series.push_back(series_of(scores, scores[i], value, name));
  }
  return chart;
}

std::string letter(std::size_t i) { return fmt::format("({})", static_cast<char>('a' + i)); }

}  // namespace

LabFigure figure_by_samples(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress) {
  const FieldMap map = config.map ? *config.map : hallway_field();
  std::vector<std::size_t> counts = paper_counts(map);
  LabFigure figure{
      .csv = {},
      .sheet = {
          .heading = fmt::format("Figure 5: {} by total variation from K of its {} cells", map.name, map.cells.size()),
          .charts = {picture_of(map, map.cells, "the field", "white 0 (free) to black 1 (occupied)")},
          .columns = 2}};
  const auto show = [&](CellChoice choice, std::size_t count) {
    const std::string title =
        fmt::format("{} K = {}, {} cells", letter(figure.sheet.charts.size() - 1), count, name_of(choice));
    figure.sheet.charts.push_back(recovered_picture(map, choice, FieldPrior::kTotalVariation, count, title));
  };
  for (const std::size_t count : counts) show(CellChoice::kRandom, count);
  show(CellChoice::kUncertain, counts.front());
  std::ranges::reverse(counts);
  const RecoveryStudy study{.counts = counts,
                            .priors = {FieldPrior::kTotalVariation},
                            .choices = {CellChoice::kRandom, CellChoice::kUncertain},
                            .seeds = config.seeds};
  const std::vector<RecoveryScore> scores = run_recovery_study(study, {map}, workers, progress);
  figure.csv = recovery_csv(scores);
  figure.sheet.charts.push_back(curves(scores, &MapQuality::relative_error, "relative error", "||m - mhat|| / ||m||"));
  figure.sheet.charts.push_back(curves(scores, &MapQuality::wall_f1, "walls", "F1 of occupied cells"));
  figure.sheet.note =
      fmt::format("Pictures: seed 1. Curves: means over {} seeds, 95 % interval; 'uncertain' is ours", config.seeds);
  return figure;
}

LabFigure figure_by_prior(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress) {
  const FieldMap map = config.map ? *config.map : hallway_field();
  const std::size_t count = std::min(kFigure6Count, paper_counts(map).front());
  const std::array<FieldPrior, 3> priors{FieldPrior::kDct, FieldPrior::kHaar, FieldPrior::kTotalVariation};
  const std::array<const char*, 3> titles{"(a) least l1 norm in DCT", "(b) least l1 norm in Haar",
                                          "for comparison: total variation"};
  LabFigure figure{.csv = {},
                   .sheet = {.heading = fmt::format("Figure 6: {} from K = {} of its {} cells in two bases", map.name,
                                                    count, map.cells.size()),
                             .charts = {},
                             .columns = 3}};
  for (std::size_t i = 0; i < priors.size(); ++i) {
    figure.sheet.charts.push_back(recovered_picture(map, CellChoice::kRandom, priors[i], count, titles[i]));
  }
  std::vector<std::size_t> counts = paper_counts(map);
  std::ranges::reverse(counts);
  const RecoveryStudy study{
      .counts = counts, .priors = {priors.begin(), priors.end()}, .seeds = std::min(config.seeds, 5)};
  const std::vector<RecoveryScore> scores = run_recovery_study(study, {map}, workers, progress);
  figure.csv = recovery_csv(scores);
  figure.sheet.charts.push_back(curves(scores, &MapQuality::relative_error, "relative error", "||m - mhat|| / ||m||"));
  figure.sheet.charts.push_back(curves(scores, &MapQuality::accuracy, "accuracy", "share of cells"));
  figure.sheet.charts.push_back(curves(scores, &MapQuality::wall_f1, "walls", "F1 of occupied cells"));
  figure.sheet.note =
      fmt::format("Pictures: seed 1, values cut to [0, 1]. Curves: means over {} seeds, 95 % interval", study.seeds);
  return figure;
}

}  // namespace cogslam
