// Figures 15 and 18: what the filter makes of less and less data, and how long it takes.
#include <fmt/format.h>

#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/percent_curves.hpp"

namespace cogslam {
namespace {

std::vector<CurvePanel> error_panels(const std::vector<CurveRows>& filter, const std::vector<CurveRows>& true_poses) {
  const ChartAxis path{.label = "path MSE [m2]", .log = true}, grid{.label = "MSE of probability", .log = true};
  ChartAxis path_to_og = path, grid_to_og = grid;
  path_to_og.min = 1e-10;
  path_to_og.max = 1.0;
  grid_to_og.min = 1e-12;
  grid_to_og.max = 1.0;
  std::vector<CurvePanel> panels;
  panels.push_back(percent_panel("(a) path, beside OG's", "path_mse_vs_baseline_m2", path_to_og, filter));
  panels.push_back(percent_panel("(b) map, beside OG's", "grid_mse_vs_baseline", grid_to_og, filter));
  panels.push_back(percent_panel("(c) path, beside the true one", "path_mse_m2", path, filter));
  panels.push_back(percent_panel("(d) map, beside the true one", "grid_mse", grid, filter));
  panels.push_back(
      percent_panel("(e) map from true poses, beside OG's", "grid_mse_vs_baseline", grid_to_og, true_poses));
  panels.push_back(percent_panel("(f) map from true poses, beside the true one", "grid_mse", grid, true_poses));
  return panels;
}

LabFigure errors(const std::string& heading, const std::string& setting, const std::vector<CurveRows>& filter,
                 const std::vector<CurveRows>& true_poses) {
  const std::vector<CurvePanel> panels = error_panels(filter, true_poses);
  return curve_figure(heading, panels, 2,
                      setting + "; mean of " + seeds_text(panels) + ", 95 % band; no difference lies on the axis");
}

std::string particles(const MeasuredSweep& sweep) {
  return fmt::format("{} particles", sweep.plan.episodes.front().particles);
}

}  // namespace

LabFigure figure_mse_by_percent_kept(const FigureInputs& inputs) {
  const MeasuredSweep &l2 = inputs.sweep("paper_l2"), &cs = inputs.sweep("paper_cs");
  const auto curves = [&](bool true_poses) {
    std::vector<CurveRows> all{og_rows(l2.table, true_poses)};
    for (CurveRows& rows : recovery_rows(l2.table, {kTopL2}, true_poses)) all.push_back(std::move(rows));
    for (CurveRows& rows : recovery_rows(cs.table, {kTopCs, kHadamardCs}, true_poses)) all.push_back(std::move(rows));
    return all;
  };
  return errors("Figure 15: errors over the data kept, the paper's motion proposal",
                "Simple room, cells of 0.1 m, motion proposal, " + particles(l2), curves(false), curves(true));
}

LabFigure figure_mse_by_percent_kept_matched(const FigureInputs& inputs) {
  const EpisodeTable& table = inputs.sweep("compression").table;
  const auto curves = [&](bool true_poses) {
    std::vector<CurveRows> all{og_rows(table, true_poses)};
    for (CurveRows& rows : recovery_rows(table, {kTopL2, kHadamardCs}, true_poses)) all.push_back(std::move(rows));
    return all;
  };
  return errors("Figure 15 by our filter: errors over the data kept",
                "Simple room, cells of 0.1 m, scans tracked and matched; 100 particles, CS 10", curves(false),
                curves(true));
}

LabFigure figure_step_time(const FigureInputs& inputs) {
  const MeasuredSweep& sweep = inputs.sweep("paper_cs");
  std::vector<CurveRows> rows{og_rows(sweep.table, false)};
  for (CurveRows& more : recovery_rows(sweep.table, {kTopL2, kTopCs, kHadamardCs}, false)) {
    rows.push_back(std::move(more));
  }
  std::vector<CurvePanel> panels;
  panels.push_back(percent_panel("CPU time of an iteration (a registered scan, all particles)", "cpu_ms_per_registered",
                                 {.label = "CPU time [ms]", .log = true}, rows));
  return curve_figure(
      "Figure 18: time of an iteration of FastSLAM COG", panels, 1,
      "Simple room, cells of 0.1 m, motion proposal, " + particles(sweep) + "; mean of " + seeds_text(panels));
}

}  // namespace cogslam
