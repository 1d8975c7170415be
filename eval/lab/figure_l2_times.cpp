// Figure 11: l2 by the pseudo-inverse against fast l2 (Alg. 8), for the grid of the simple room in 0.1 m cells.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.hpp"
#include "eval/lab/figure.hpp"
#include "eval/lab/map_source.hpp"
#include "eval/lab/test_signal.hpp"
#include "eval/metrics/timing.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/codec/top_m.hpp"

namespace cogslam {
namespace {

constexpr double kCellSize = 0.1;  // [m]
constexpr int kRuns = 3;           // of which the median counts

struct Way {
  std::string name;
  Recovery recovery;
  int repeats;  // within one measurement, for those that take microseconds
};

/// The m coefficients of largest magnitude, zeros too where m asks for them: the time must be that of m rows.
Compressor exactly_top_m(const std::vector<double>& c, std::size_t m) {
  std::vector<std::uint32_t> order(c.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return std::abs(c[a]) > std::abs(c[b]); });
  order.resize(m);
  std::sort(order.begin(), order.end());
  return Compressor::selection(std::move(order), c.size());
}

/// Median CPU seconds of one recovery.
double seconds_of(const Way& way, Compressor& H, const std::vector<double>& y, std::vector<double>& x) {
  std::vector<double> runs;
  for (int run = 0; run < kRuns; ++run) {
    const Stopwatch watch(Clock::kThreadCpu);
    for (int i = 0; i < way.repeats; ++i) x = recover(way.recovery, H, y).x;
    runs.push_back(watch.seconds() / way.repeats);
  }
  return median(runs);
}

}  // namespace

LabFigure figure_l2_times(const LabProgress& progress) {
  using Decomposition = PseudoInverse::Decomposition;
  const Grid<float> map = ideal_room_map("simple", kCellSize);
  Basis basis(BasisKind::kDct, map.frame().width, map.frame().height);
  const std::vector<double> cells(map.values().begin(), map.values().end());
  std::vector<double> c(basis.size());
  basis.forward(cells, c);
  const std::vector<Way> ways{{"pinv by singular values (as Matlab)", PseudoInverse{Decomposition::kSvd}, 1},
                              {"pinv by orthogonal decomposition", PseudoInverse{Decomposition::kOrthogonal}, 1},
                              {"fast l2 (Alg. 8)", FastL2{}, 200}};
  std::vector<Series> series(ways.size());
  LabFigure figure{.csv = "way,percent,m,n,cpu_ms_median\n"};
  std::vector<std::vector<double>> found(ways.size());
  const std::vector<double> percents = twenty_percents();
  for (std::size_t i = 0; i < percents.size(); ++i) {
    Compressor H = exactly_top_m(c, kept_count(c.size(), percents[i]));
    std::vector<double> y(H.rows());
    H.apply(c, y);
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const double seconds = seconds_of(ways[w], H, y, found[w]);
      series[w].name = ways[w].name;
      series[w].x.push_back(percents[i]);
      series[w].y.push_back(1e3 * seconds);
      figure.csv +=
          fmt::format("\"{}\",{},{},{},{:.6g}\n", ways[w].name, percents[i], H.rows(), c.size(), 1e3 * seconds);
      ENSURES(mean_squared_error(found[w], found.front()) < 1e-20);  // all three are the same answer
    }
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(percents.size()));
  }
  figure.sheet = {.heading = fmt::format("Figure 11: l2 by pseudo-inverse and fast l2, top m of n = {}", c.size()),
                  .note = fmt::format("median of {} runs in one process; at 100 % pinv takes {:.2g} times as long as "
                                      "fast l2",
                                      kRuns, series[0].y.back() / series[2].y.back())};
  const ChartAxis x{.label = "% of the data", .min = 0.0, .max = 100.0};
  Chart linear;
  linear.title = "(a) as the paper: linear";
  linear.x = x;
  linear.y = {.label = "CPU time [ms]", .min = 0.0};
  linear.series = series;
  Chart logarithmic = linear;
  logarithmic.title = "(b) logarithmic";
  logarithmic.y = {.label = "CPU time [ms]", .log = true};
  figure.sheet.charts.push_back(linear);
  figure.sheet.charts.push_back(logarithmic);
  figure.sheet.columns = 2;
  return figure;
}

}  // namespace cogslam
