// Figures 12 to 14: path and map of one drive, by OG and from 40 % of the coefficients.
#include <fmt/format.h>

#include "eval/figures/episode_score.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/picture.hpp"

namespace cogslam {
namespace {

constexpr double kCellSize = 0.1;  // [m]
constexpr const char* kSetting = "Simple room of 10 x 12 ft, cells of 0.1 m, motion proposal, {} particles, seed {}";

/// A sweep's first drive through its only room.
class Drives {
 public:
  Drives(const MeasuredSweep& sweep, Workers& workers)
      : sweep_(sweep), workers_(workers), readings_(readings_of(sweep, sweep.plan.episodes.front())) {}

  [[nodiscard]] const TruthLog& truth() const { return readings_.truth; }
  [[nodiscard]] const Recording& recording() const { return readings_.recording; }
  [[nodiscard]] VariantRun run(const std::string& variant) const {
    return run_again(sweep_, planned(sweep_.plan, name(variant)), readings_, workers_);
  }
  [[nodiscard]] std::string score(const std::string& variant, const std::string& column, double unit) const {
    const auto value = episode_score(sweep_.table, name(variant), column);
    return value ? fmt::format("{:.3g}", unit * *value) : "-";
  }
  [[nodiscard]] std::string setting() const {
    const PlannedEpisode& first = sweep_.plan.episodes.front();
    return fmt::format(kSetting, first.particles, first.seed);
  }

 private:
  [[nodiscard]] EpisodeName name(const std::string& variant) const {
    return {sweep_.plan.episodes.front().world, kCellSize, variant, sweep_.plan.episodes.front().seed};
  }

  const MeasuredSweep& sweep_;
  Workers& workers_;
  CachedReadings readings_;
};

void add_run(const Drives& drives, const std::string& variant, const std::string& title, LabFigure& figure) {
  const VariantRun og = drives.run("og"), run = drives.run(variant);
  const std::vector<NamedPath> paths{{"truth", true_path(drives.truth())}, {"OG", og.online}, {title, run.online}};
  figure.sheet.charts.push_back(path_chart(
      fmt::format("Path by {}; MSE to OG's {} cm2", title, drives.score(variant, "path_mse_vs_baseline_m2", 1e4)),
      drives.truth().world, paths));
  figure.sheet.charts.push_back(
      map_chart("Map by " + title, "grid MSE to OG's " + drives.score(variant, "grid_mse_vs_baseline", 1.0), run.map));
  if (figure.csv == kPictureHead) figure.csv += path_csv(paths[0]) + path_csv(paths[1]) + map_csv("OG", og.map);
  figure.csv += path_csv(paths[2]) + map_csv(title, run.map);
}

}  // namespace

LabFigure figure_baseline(const FigureInputs& inputs) {
  const Drives drives(inputs.sweep("paper_l2"), inputs.workers);
  const VariantRun og = drives.run("og");
  const std::vector<NamedPath> paths{
      {"truth", true_path(drives.truth())}, {"odometry", odometry_path(drives.recording())}, {"OG", og.online}};
  LabFigure figure{
      .csv = kPictureHead,
      .sheet = {.heading = "Figure 12: the baseline, FastSLAM OG", .columns = 2, .note = drives.setting()}};
  figure.sheet.charts = {
      path_chart(fmt::format("(a) Paths; MSE of OG {} cm2, of odometry {} cm2", drives.score("og", "path_mse_m2", 1e4),
                             drives.score("og", "odometry_path_mse_m2", 1e4)),
                 drives.truth().world, paths),
      map_chart("(b) OG's map", "grid MSE to the truth " + drives.score("og", "grid_mse", 1.0), og.map)};
  for (const NamedPath& path : paths) figure.csv += path_csv(path);
  figure.csv += map_csv("OG", og.map);
  return figure;
}

LabFigure figure_l2_path_and_map(const FigureInputs& inputs) {
  const Drives drives(inputs.sweep("paper_l2"), inputs.workers);
  LabFigure figure{.csv = kPictureHead,
                   .sheet = {.heading = "Figure 13: FastSLAM COG from 40 % of the coefficients by l2",
                             .columns = 2,
                             .note = drives.setting()}};
  add_run(drives, "l2_40", "l2 from the top 40 %", figure);
  return figure;
}

LabFigure figure_cs_path_and_map(const FigureInputs& inputs) {
  const Drives drives(inputs.sweep("paper_cs"), inputs.workers);
  LabFigure figure{.csv = kPictureHead,
                   .sheet = {.heading = "Figure 14: FastSLAM COG from 40 % of the coefficients by compressed sensing",
                             .columns = 2,
                             .note = drives.setting()}};
  add_run(drives, "cs_40", "CS from the top 40 %", figure);
  add_run(drives, "cs_hadamard_40", "CS from Hadamard rows, 40 %", figure);
  return figure;
}

}  // namespace cogslam
