// Figures 19 to 24: three rooms, what their maps are and how far they can be compressed at four cell sizes.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/number_text.hpp"
#include "eval/figures/curve.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/percent_curves.hpp"
#include "eval/figures/picture.hpp"
#include "eval/lab/map_source.hpp"
#include "eval/lab/map_study.hpp"
#include "eval/lab/signal_study.hpp"

namespace cogslam {
namespace {

constexpr std::array<double, 4> kCellSizes{1.0, 0.5, 0.2, 0.1};  // [m], as the paper
const ChartAxis kPercentAxis{.label = "% of the data", .min = 0.0, .max = 100.0};
const ChartAxis kProbabilityAxis{.label = "MSE of probability", .log = true, .min = 1e-12, .max = 1.0};
const ChartAxis kLogOddsAxis{.label = "MSE of log-odds", .log = true, .min = 1e-12, .max = 10.0};

int number_of(const std::string& room) { return room == "simple" ? 19 : room == "cornered" ? 21 : 23; }

std::string cells_of(double size) { return fmt::format("cells of {} m", size); }

/// Log-odds and probability MSE of maps compressed once, at each of twenty_percents().
struct OneShot {
  std::vector<std::vector<double>> log_odds, probability;  ///< one list of maps per percentage
};

OneShot one_shot(const std::vector<Grid<float>>& maps, const FigureInputs& inputs) {
  const MapStudy study{.percents = twenty_percents()};
  OneShot errors{std::vector<std::vector<double>>(study.percents.size()),
                 std::vector<std::vector<double>>(study.percents.size())};
  for (const Grid<float>& map : maps) {
    const std::vector<MapScore> scores = run_map_study(study, map, inputs.workers, [](double /*done*/) {});
    for (std::size_t i = 0; i < scores.size(); ++i) {
      errors.log_odds[i].push_back(scores[i].mse_log_odds);
      errors.probability[i].push_back(scores[i].mse_probability);
    }
  }
  return errors;
}

/// OG's final map of every drive through a room.
std::vector<Grid<float>> final_maps(const MeasuredSweep& sweep, const std::string& room, double cell_size,
                                    const FigureInputs& inputs) {
  std::vector<Grid<float>> maps;
  for (const PlannedEpisode& episode : sweep.plan.episodes) {
    if (episode.world != room || episode.cell_size != cell_size || episode.variant != "og") continue;
    maps.push_back(run_again(sweep, episode, readings_of(sweep, episode), inputs.workers).map);
  }
  return maps;
}

void add_curve(const std::string& title, const std::string& name, const std::vector<std::vector<double>>& errors,
               const ChartAxis& axis, Chart& chart, std::string& csv) {
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    points.push_back({"", "", twenty_percents()[i], mean_interval(errors[i])});
    const MeanInterval& y = points.back().y;
    const bool spread = y.count > 1;
    csv += fmt::format("\"{}\",\"{}\",\"{}\",,,{},{},{},{},{}\n", title, axis.label, name, number_text(points.back().x),
                       y.count, number_text(y.mean), spread ? number_text(y.low()) : "",
                       spread ? number_text(y.high()) : "");
  }
  chart.title = title;
  chart.x = kPercentAxis;
  chart.y = axis;
  chart.series.push_back(series_of(name, points, axis));
}

/// Probability and log-odds error of compressing maps once, a curve for each cell size.
template <class MapsOf>
void add_one_shot(const std::string& letters, const std::string& what, MapsOf maps_of, const FigureInputs& inputs,
                  LabFigure& figure) {
  Chart probability, log_odds;
  for (const double size : kCellSizes) {
    const OneShot errors = one_shot(maps_of(size), inputs);
    add_curve(fmt::format("({}) {}", letters[0], what), cells_of(size), errors.probability, kProbabilityAxis,
              probability, figure.csv);
    add_curve(fmt::format("({}) {}", letters[1], what), cells_of(size), errors.log_odds, kLogOddsAxis, log_odds,
              figure.csv);
  }
  figure.sheet.charts.push_back(std::move(probability));
  figure.sheet.charts.push_back(std::move(log_odds));
}

std::vector<CurveRows> in_the_loop(const EpisodeTable& table, const std::string& room, bool true_poses) {
  std::vector<CurveRows> all;
  for (const double size : kCellSizes) {
    CurveRows rows = recovery_rows(table, {kTopL2}, true_poses).front();
    rows.name = cells_of(size);
    rows.look = std::nullopt;
    rows.takes = [size, room, takes = rows.takes](const EpisodeRow& row) {
      return takes(row) && row.text("world") == room && row.number("cell_size_m") == size;
    };
    all.push_back(std::move(rows));
  }
  return all;
}

std::vector<CurvePanel> loop_panels(const EpisodeTable& table, const std::string& room) {
  const auto mapped = in_the_loop(table, room, true), filtered = in_the_loop(table, room, false);
  const ChartAxis path{.label = "path MSE [m2]", .log = true, .min = 1e-10, .max = 1.0};
  const ChartAxis truth{.label = "MSE of log-odds", .log = true};
  std::vector<CurvePanel> panels;
  panels.push_back(
      percent_panel("(e) in the loop, true poses, beside OG's map", "grid_mse_vs_baseline", kProbabilityAxis, mapped));
  panels.push_back(percent_panel("(f) in the loop, true poses, beside the truth", "grid_mse_logodds", truth, mapped));
  panels.push_back(
      percent_panel("(g) the filter's map, beside OG's", "grid_mse_vs_baseline", kProbabilityAxis, filtered));
  panels.push_back(percent_panel("(h) the filter's path, beside OG's", "path_mse_vs_baseline_m2", path, filtered));
  return panels;
}

}  // namespace

LabFigure figure_room_map(const FigureInputs& inputs, const std::string& room) {
  const MeasuredSweep& sweep = inputs.sweep("rooms");
  const auto episode = std::find_if(sweep.plan.episodes.begin(), sweep.plan.episodes.end(), [&](const auto& e) {
    return e.world == room && e.variant == "og" && e.cell_size == kCellSizes.back();
  });
  const CachedReadings readings = readings_of(sweep, *episode);
  const Grid<float> truth = ideal_room_map(room, kCellSizes.back());
  const Grid<float> map = run_again(sweep, *episode, readings, inputs.workers).map;
  LabFigure figure{.csv = kPictureHead + map_csv("truth", truth) + map_csv("OG", map),
                   .sheet = {.heading = fmt::format("Figure {}: the {} room, 100 % of the data", number_of(room), room),
                             .columns = 2,
                             .note = fmt::format("Cells of 0.1 m, motion proposal, {} particles, seed {}",
                                                 episode->particles, episode->seed)}};
  figure.sheet.charts = {
      map_chart("(a) ideal map", fmt::format("{} x {} cells", truth.frame().width, truth.frame().height), truth),
      map_chart("(b) OG's final map", fmt::format("{} x {} cells", map.frame().width, map.frame().height), map)};
  return figure;
}

LabFigure figure_room_compression(const FigureInputs& inputs, const std::string& room) {
  const MeasuredSweep& sweep = inputs.sweep("rooms");
  const std::vector<CurvePanel> panels = loop_panels(sweep.table, room);
  LabFigure figure = curve_figure(
      fmt::format("Figure {}: the {} room, error over the data kept", number_of(room) + 1, room), panels, 2,
      fmt::format("l2 from the top m Haar coefficients; OG's maps and (e) to (h): motion proposal, {} "
                  "particles, {}. No error lies on the axis",
                  sweep.plan.episodes.front().particles, seeds_text(panels)));
  std::vector<Chart> looped;
  looped.swap(figure.sheet.charts);
  add_one_shot(
      "ab", "ideal map, once", [&](double size) { return std::vector{ideal_room_map(room, size)}; }, inputs, figure);
  add_one_shot(
      "cd", "OG's final map, once", [&](double size) { return final_maps(sweep, room, size, inputs); }, inputs, figure);
  figure.sheet.charts.insert(figure.sheet.charts.end(), looped.begin(), looped.end());
  return figure;
}

}  // namespace cogslam
