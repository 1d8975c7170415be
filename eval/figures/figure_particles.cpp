// What the paper lacks: more particles, or better maps, for the same bytes?
#include <fmt/format.h>

#include "core/number_text.hpp"
#include "eval/figures/curve.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/thresholds.hpp"

namespace cogslam {
namespace {

constexpr double kBytesPerKilobyte = 1000.0;

/// A curve for each store: variants are called <store>_p<particles>.
std::vector<CurveRows> store_rows(const EpisodeTable& table) {
  std::vector<CurveRows> all;
  for (const auto& [name, title] : {std::pair{"dense", "dense (OG)"},
                                    {"l2_40", "40 % of coefficients"},
                                    {"l2_10", "10 % of coefficients"},
                                    {"tiles", "tiles"}}) {
    all.push_back({.name = title, .table = &table});
    all.back().takes = [prefix = std::string(name) + "_p"](const EpisodeRow& row) {
      return row.text("variant").starts_with(prefix);
    };
  }
  return all;
}

RowNumber total_kilobytes() {
  return [](const EpisodeRow& row) -> std::optional<double> {
    const auto bytes = row.number("bytes"), particles = row.number("particles");
    if (!bytes || !particles) return std::nullopt;
    return *bytes * *particles / kBytesPerKilobyte;
  };
}

}  // namespace

LabFigure figure_error_by_particles(const FigureInputs& inputs) {
  const EpisodeTable& table = inputs.sweep("particles").table;
  const ChartAxis error{.label = "path MSE [m2]", .log = true};
  const ChartAxis budget{.label = "bytes of all particles, all-in [kB]", .log = true};
  std::vector<CurvePanel> panels(2);
  panels[0] = {.title = "(a) by particles", .y_axis = error, .x = column("particles"), .y = column("path_mse_m2")};
  panels[0].x_axis.label = "particles";
  panels[0].x_axis.log = true;
  panels[1] = {
      .title = "(b) by bytes", .x_axis = budget, .y_axis = error, .x = total_kilobytes(), .y = column("path_mse_m2")};
  for (CurvePanel& panel : panels) panel.curves = store_rows(table);
  LabFigure figure =
      curve_figure("Error over particles, and for the same bytes", panels, 3,
                   "Simple room, cells of 0.1 m, motion proposal; mean of " + seeds_text(panels) + ", 95 % band");
  Chart& chart = figure.sheet.charts.emplace_back();
  chart.title = "(c) the most particles that a budget holds";
  chart.x = {.label = "budget [kB]", .log = true};
  chart.y = error;
  for (const CurveRows& rows : store_rows(table)) {
    const std::vector<CurvePoint> within =
        within_budgets(curve_points(rows, total_kilobytes(), column("path_mse_m2")), {10, 20, 40, 80, 160, 320, 640});
    chart.series.push_back(series_of(rows.name, within, error));
    for (const CurvePoint& point : within) {
      figure.csv += fmt::format("\"{}\",\"{}\",\"{}\",{},{},{},{},{},{},{}\n", chart.title, error.label, rows.name,
                                point.world, point.variant, number_text(point.x), point.y.count,
                                number_text(point.y.mean), number_text(point.y.low()), number_text(point.y.high()));
    }
  }
  return figure;
}

}  // namespace cogslam
