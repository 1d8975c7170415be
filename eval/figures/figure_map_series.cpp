// Figures 16 and 17: the final map from less and less data, by l2 and by compressed sensing.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/number_text.hpp"
#include "eval/figures/episode_score.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/picture.hpp"

namespace cogslam {
namespace {

constexpr double kCellSize = 0.1;                                               // [m]
constexpr std::array<double, 9> kPercents{75, 70, 60, 50, 40, 30, 25, 20, 10};  // as the paper

/// The maps of `variant` at every percentage that the sweep has, of its first drive.
void add_series(const MeasuredSweep& sweep, const std::string& variant, const std::string& title,
                const FigureInputs& inputs, LabFigure& figure) {
  const PlannedEpisode& first = sweep.plan.episodes.front();
  const CachedReadings readings = readings_of(sweep, first);
  for (const double percent : kPercents) {
    const EpisodeName name{first.world, kCellSize, variant + "_" + number_text(percent), first.seed};
    const auto error = episode_score(sweep.table, name, "grid_mse_vs_baseline");
    if (!error) continue;  // not swept
    const VariantRun run = run_again(sweep, planned(sweep.plan, name), readings, inputs.workers);
    const double path = episode_score(sweep.table, name, "path_mse_vs_baseline_m2").value_or(0.0);
    figure.sheet.charts.push_back(
        map_chart(fmt::format("{}: {} %", title, percent),
                  fmt::format("MSE to OG's: grid {:.2g}, path {:.2g} cm2", *error, 1e4 * path), run.map));
    figure.csv += map_csv(fmt::format("{} {} %", title, percent), run.map);
  }
}

/// How far the maps and paths of `variant` lie from those of `other` at the same percentages, over all seeds.
struct Likeness {
  std::size_t same_maps = 0, episodes = 0;
  double grid = 0.0, path = 0.0;  ///< largest differences of their scores
};

Likeness likeness(const EpisodeTable& table, const std::string& variant, const std::string& other) {
  Likeness like;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string name = table.text(row, "variant");
    if (!name.starts_with(variant + "_") || table.number(row, "true_poses") == 1.0) continue;
    EpisodeName twin{table.text(row, "world"), *table.number(row, "cell_size_m"), other + name.substr(variant.size()),
                     static_cast<std::uint32_t>(*table.number(row, "seed"))};
    const auto found = episode_row(table, twin);
    if (!found || table.text(row, "recovery") != "nesta" || table.text(row, "compressor") != "top_m") continue;
    ++like.episodes;
    if (table.text(row, "map_hash") == table.text(*found, "map_hash")) ++like.same_maps;
    const auto difference = [&](const char* column) {
      return std::abs(table.number(row, column).value_or(0.0) - table.number(*found, column).value_or(0.0));
    };
    like.grid = std::max(like.grid, difference("grid_mse"));
    like.path = std::max(like.path, difference("path_mse_m2"));
  }
  return like;
}

std::string setting(const MeasuredSweep& sweep) {
  return fmt::format("Simple room, cells of 0.1 m, motion proposal, {} particles, seed {}",
                     sweep.plan.episodes.front().particles, sweep.plan.episodes.front().seed);
}

}  // namespace

LabFigure figure_l2_map_series(const FigureInputs& inputs) {
  const MeasuredSweep& sweep = inputs.sweep("paper_l2");
  LabFigure figure{.csv = kPictureHead,
                   .sheet = {.heading = "Figure 16: final maps of FastSLAM COG by l2 from the top m",
                             .columns = 3,
                             .note = setting(sweep)}};
  add_series(sweep, "l2", "l2", inputs, figure);
  return figure;
}

LabFigure figure_cs_map_series(const FigureInputs& inputs) {
  const MeasuredSweep& sweep = inputs.sweep("paper_cs");
  const Likeness like = likeness(sweep.table, "cs", "l2");
  LabFigure figure{.csv = kPictureHead,
                   .sheet = {.heading = "Figure 17: final maps of FastSLAM COG by compressed sensing",
                             .columns = 3,
                             .note = setting(sweep) +
                                     fmt::format(". CS of the top m beside l2, all seeds: {} of {} maps the same in "
                                                 "every bit, grid MSE within {:.1e}, path MSE within {:.1e} m2",
                                                 like.same_maps, like.episodes, like.grid, like.path)}};
  add_series(sweep, "cs", "CS, top m", inputs, figure);
  add_series(sweep, "cs_hadamard", "CS, Hadamard rows", inputs, figure);
  return figure;
}

}  // namespace cogslam
