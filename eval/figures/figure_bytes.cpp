// What the paper lacks: error over real bytes, of every store, with plain packing of a whole map beside it.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/number_text.hpp"
#include "eval/figures/curve.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/pareto.hpp"
#include "eval/lab/yardstick.hpp"

namespace cogslam {
namespace {

constexpr const char* kBytesLabel = "bytes per particle, all-in (mean over registered scans)";

struct StoreCurve {
  const char* name;
  const char* store;
};
constexpr std::array kStores{StoreCurve{"dense (OG)", "dense"}, StoreCurve{"coefficients", "coefficients"},
                             StoreCurve{"lattice, a byte a cell", "lattice"}, StoreCurve{"tiles", "tiles"},
                             StoreCurve{"two-resolution tiles", "two_resolution"}};

std::vector<CurveRows> store_rows(const EpisodeTable& table, double cell_size) {
  std::vector<CurveRows> all;
  for (const StoreCurve& curve : kStores) {
    all.push_back({.name = curve.name, .table = &table});
    all.back().takes = [curve, cell_size](const EpisodeRow& row) {
      return row.text("store") == curve.store && row.number("cell_size_m") == cell_size;
    };
  }
  return all;
}

CurvePanel panel_of(const EpisodeTable& table, double cell_size, const std::string& title, const ChartAxis& y_axis,
                    const std::string& score) {
  return {title,         {.label = kBytesLabel, .log = true}, y_axis, column("bytes"),
          column(score), store_rows(table, cell_size)};
}

void add_front(const CurvePanel& panel, Chart& chart) {
  std::vector<Offer> offers;
  for (const CurveRows& rows : panel.curves) {
    for (const CurvePoint& point : curve_points(rows, panel.x, panel.y)) offers.push_back({point.x, point.y.mean});
  }
  Series series{.name = "Pareto front", .style = SeriesStyle::kLineOnly, .look = 6};
  for (const Offer& offer : pareto_front(offers)) {
    series.x.push_back(offer.price);
    series.y.push_back(offer.error);
  }
  chart.series.push_back(std::move(series));
}

/// OG's final maps packed as a whole: the bytes of one map alone, the error OG's.
void add_yardsticks(const FigureInputs& inputs, double cell_size, const CurvePanel& panel, Chart& chart,
                    std::string& csv) {
  const MeasuredSweep& sweep = inputs.sweep("bytes");
  const double error = curve_points(panel.curves.front(), panel.x, panel.y).front().y.mean;
  Series series{.name = "OG's map packed whole", .style = SeriesStyle::kPointsOnly, .look = 5};
  for (const Yardstick yardstick : kYardsticks) {
    std::vector<double> bytes;
    for (const PlannedEpisode& episode : sweep.plan.episodes) {
      if (episode.variant != "dense" || episode.cell_size != cell_size) continue;
      const Grid<float> map = run_again(sweep, episode, readings_of(sweep, episode), inputs.workers).map;
      bytes.push_back(static_cast<double>(encode_map(yardstick, map).size()));
    }
    const double mean = mean_interval(bytes).mean;
    series.x.push_back(mean);
    series.y.push_back(error);
    csv += fmt::format("\"{}\",\"{}\",\"{}\",,{},{},{},{},,\n", panel.title, panel.y_axis.label, series.name,
                       name_of(yardstick), number_text(mean), bytes.size(), number_text(error));
  }
  chart.series.push_back(std::move(series));
}

}  // namespace

LabFigure figure_error_by_bytes(const FigureInputs& inputs) {
  const MeasuredSweep& sweep = inputs.sweep("bytes");
  std::vector<CurvePanel> panels;
  std::vector<double> sizes;
  for (const PlannedEpisode& episode : sweep.plan.episodes) {
    if (std::find(sizes.begin(), sizes.end(), episode.cell_size) == sizes.end()) sizes.push_back(episode.cell_size);
  }
  for (const double size : sizes) {
    panels.push_back(panel_of(sweep.table, size, fmt::format("map, cells of {} m", size),
                              {.label = "grid MSE to the truth"}, "grid_mse"));
    panels.push_back(panel_of(sweep.table, size, fmt::format("path, cells of {} m", size),
                              {.label = "path MSE to the truth [m2]"}, "path_mse_m2"));
  }
  const PlannedEpisode& first = sweep.plan.episodes.front();
  LabFigure figure = curve_figure(
      "Error over real bytes", panels, 2,
      fmt::format("Room {}, the filter as shipped, {} particles; mean of {}, 95 % band; packed: bytes of one map "
                  "alone, error OG's",
                  first.world, first.particles, seeds_text(panels)));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    add_front(panels[i], figure.sheet.charts[i]);
    if (i % 2 == 0) add_yardsticks(inputs, sizes[i / 2], panels[i], figure.sheet.charts[i], figure.csv);
  }
  return figure;
}

}  // namespace cogslam
