// Figures 9 and 10: an occupancy grid, its Haar coefficients, and how it comes back.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "eval/lab/figure.hpp"
#include "eval/lab/map_source.hpp"
#include "eval/lab/test_signal.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/codec/top_m.hpp"

namespace cogslam {
namespace {

constexpr int kSide = 64;
constexpr double kCellSize = 0.06;  // [m]: the simple room just fits
constexpr double kGap = 1e-4;       // relative duality gap at which NESTA ends
constexpr int kIterations = 4000;   // or it ends here: from few rows the gap closes too slowly to matter

std::vector<double> haar_coefficients(const Grid<float>& map) {
  Basis basis(BasisKind::kHaar, map.frame().width, map.frame().height);
  const std::vector<double> cells(map.values().begin(), map.values().end());
  std::vector<double> c(basis.size());
  basis.forward(cells, c);
  return c;
}

std::size_t non_zeros(const std::vector<double>& c) {
  return static_cast<std::size_t>(std::count_if(c.begin(), c.end(), [](double v) { return v != 0.0; }));
}

/// MSE of the grid, by Parseval; `cut_off` counts recoveries that ended before their rule was met.
double mse_of(const Recovery& recovery, Compressor H, const std::vector<double>& c, std::atomic<int>& cut_off) {
  std::vector<double> y(H.rows());
  H.apply(c, y);
  const Recovered recovered = recover(recovery, H, y);
  if (!recovered.converged) ++cut_off;
  return mean_squared_error(c, recovered.x);
}

Recovery compressed_sensing() {
  Nesta nesta = Nesta::to_gap(kGap);
  nesta.max_iterations = kIterations;
  return nesta;
}

/// MSE by percentage and seed; one entry per percentage where no chance is involved.
struct GridScores {
  std::string name;
  std::vector<std::vector<double>> mse;
};

Series series_of(const GridScores& scores, const std::vector<double>& percents) {
  Series series{.name = scores.name};
  for (std::size_t i = 0; i < percents.size(); ++i) {
    const MeanInterval mse = mean_interval(scores.mse[i]);
    series.x.push_back(percents[i]);
    series.y.push_back(mse.mean);
    series.low.push_back(mse.low());
    series.high.push_back(mse.high());
  }
  return series;
}

std::vector<GridScores> grid_scores(const FigureConfig& config, const std::vector<double>& percents, Workers& workers,
                                    const LabProgress& progress, std::atomic<int>& cut_off) {
  const std::vector<double> c = haar_coefficients(example_grid());
  const std::size_t n = c.size(), seeds = static_cast<std::size_t>(config.seeds);
  const Recovery l2 = FastL2{}, cs = compressed_sensing();
  const std::vector<std::vector<double>> drawn(percents.size(), std::vector<double>(seeds));
  std::vector<GridScores> all{
      {"l2, Hadamard rows", drawn}, {"CS, Hadamard rows", drawn}, {"l2, top m", {}}, {"CS, top m", {}}};
  for (const double percent : percents) {
    const Compressor top = make_top_m(c, kept_count(n, percent));
    all[2].mse.push_back({mse_of(l2, top, c, cut_off)});
    all[3].mse.push_back({mse_of(cs, top, c, cut_off)});
  }
  for_each_seed(seeds * percents.size(), workers, progress, [&](std::size_t index) {
    const std::size_t seed = index / percents.size(), i = index % percents.size();
    const Compressor H =
        make_compressor(CompressorKind::kHadamard, kept_count(n, percents[i]), n, static_cast<std::uint32_t>(seed) + 1);
    all[0].mse[i][seed] = mse_of(l2, H, c, cut_off);
    all[1].mse[i][seed] = mse_of(cs, H, c, cut_off);
  });
  return all;
}

}  // namespace

Grid<float> example_grid() { return centred_in(ideal_room_map("simple", kCellSize), kSide, kSide); }

LabFigure figure_example_grid() {
  const Grid<float> map = example_grid();
  const std::vector<double> c = haar_coefficients(map);
  Grid<float> picture({.width = kSide, .height = kSide});
  LabFigure figure{.csv = "row,column,log_odds,coefficient\n"};
  for (std::size_t i = 0; i < c.size(); ++i) {
    picture.values()[i] = static_cast<float>(c[i]);
    figure.csv += fmt::format("{},{},{},{}\n", i / kSide, i % kSide, map.values()[i], c[i]);
  }
  figure.sheet = {.heading = "Figure 9: an example grid and its Haar coefficients",
                  .charts = {{.title = "(a) ideal log-odds of the simple room",
                              .x = {.label = "64 x 64 cells of 0.06 m; black: wall, grey: unknown"},
                              .image = ChartImage{.values = map}},
                             {.title = fmt::format("(b) {} of {} coefficients are not zero", non_zeros(c), c.size()),
                              .x = {.label = "coarse at the upper left; red above, blue below zero"},
                              .image = ChartImage{.values = picture, .diverging = true, .y_down = true}}},
                  .columns = 2};
  return figure;
}

LabFigure figure_grid_recoveries(const FigureConfig& config, Workers& workers, const LabProgress& progress) {
  const std::vector<double> percents = twenty_percents();
  std::atomic<int> cut_off{0};
  const std::vector<GridScores> all = grid_scores(config, percents, workers, progress, cut_off);
  LabFigure figure{
      .csv = "scheme,percent,seeds,mse_mean,mse_low95,mse_high95\n",
      .sheet = {.heading = "Figure 10: the grid of figure 9 from Hadamard rows and from its top m",
                .columns = 2,
                .note = fmt::format("Mean over {} seeds, 95 % interval; CS of the top m is l2. {} of {} CS runs "
                                    "ended at {} steps, above a gap of {}",
                                    config.seeds, cut_off.load(), config.seeds * percents.size(), kIterations, kGap)}};
  const ChartAxis x{.label = "% of the data", .min = 0.0, .max = 100.0};
  Chart linear{.title = "(a) as the paper: linear", .x = x, .y = {.label = "MSE of log-odds", .min = 0.0}};
  for (const GridScores& scores : all) {
    linear.series.push_back(series_of(scores, percents));
    for (std::size_t i = 0; i < percents.size(); ++i) {
      const MeanInterval mse = mean_interval(scores.mse[i]);
      figure.csv +=
          fmt::format("\"{}\",{},{},{},{},{}\n", scores.name, percents[i], mse.count, mse.mean, mse.low(), mse.high());
    }
  }
  Chart logarithmic = linear;
  logarithmic.title = "(b) logarithmic; exact recovery falls off the scale";
  logarithmic.y = {.label = "MSE of log-odds", .log = true, .min = 1e-10, .max = 10.0};
  figure.sheet.charts = {linear, logarithmic};
  return figure;
}

}  // namespace cogslam
