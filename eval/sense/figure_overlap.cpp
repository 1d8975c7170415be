// Figures 3 and 4: two partial maps over each other before and after the offset is known, and the flow between them.
#include <fmt/format.h>

#include <cmath>

#include "eval/sense/figure.hpp"
#include "eval/sense/hallway_study.hpp"

namespace cogslam {
namespace {

constexpr std::uint32_t kSeed = 1;
constexpr int kDrawnTimes = 5;     // arrows of true length would hide under their points
constexpr std::size_t kLook = 36;  // in the upper hallway: rooms on either side

struct Pair {
  PathLook before, now;
  CorrectedLook first, second;
  Pose2 prior;
};

Pair pair_of_looks() {
  const HallwayRun run = run_hallway(PathDriveConfig{}, PathCorrectionConfig{}, kSeed);
  return {run.looks[kLook - 1], run.looks[kLook], run.corrected[kLook - 1], run.corrected[kLook],
          run.looks[kLook - 1].T_odom_base.inverse() * run.looks[kLook].T_odom_base};
}

/// The second map minus the first over the cells that both know, in the frame of the first; 0 elsewhere.
Grid<float> difference(const Pair& pair, const Pose2& T_first_second) {
  const Grid<double>&first = pair.first.map.occupancy, &second = pair.second.map.occupancy;
  Grid<float> out(first.frame());
  const Pose2 T_second_first = T_first_second.inverse();
  for (int y = 0; y < out.frame().height; ++y) {
    for (int x = 0; x < out.frame().width; ++x) {
      const Cell there = second.frame().cell_of(T_second_first * out.frame().centre_of({x, y}));
      if (!second.frame().contains(there) || pair.first.map.weight[{x, y}] * pair.second.map.weight[there] <= 0.0)
        continue;
      out[{x, y}] = static_cast<float>(second[there] - first[{x, y}]);
    }
  }
  return out;
}

double rms(const Grid<float>& grid) {
  double sum = 0.0;
  int cells = 0;
  for (const float v : grid.values()) {
    sum += static_cast<double>(v) * v;
    cells += v != 0.0F ? 1 : 0;
  }
  return cells > 0 ? std::sqrt(sum / cells) : 0.0;
}

std::string error_of(const Pair& pair, const Pose2& T_first_second) {
  const Pose2 error = (pair.before.T_map_base.inverse() * pair.now.T_map_base).inverse() * T_first_second;
  return fmt::format("{:.2f} m, {:.2f} deg off", error.position().norm(), std::abs(degrees(error.theta)));
}

}  // namespace

LabFigure figure_overlap(const SenseFigureConfig& /*config*/, Workers& /*workers*/, const LabProgress& /*progress*/) {
  const Pair pair = pair_of_looks();
  const Pose2& found = pair.second.offset->T_first_second;
  const Grid<float> before = difference(pair, pair.prior), after = difference(pair, found);
  LabFigure figure{.csv = "x,y,before,after\n"};
  for (int y = 0; y < before.frame().height; ++y) {
    for (int x = 0; x < before.frame().width; ++x) {
      figure.csv += fmt::format("{},{},{},{}\n", x, y, before[{x, y}], after[{x, y}]);
    }
  }
  const auto chart = [&](const char* name, const Grid<float>& grid, const Pose2& T) {
    return Chart{.title = fmt::format("{}: {}, rms {:.3f}", name, error_of(pair, T), rms(grid)),
                 .x = {.label = "orange: occupied in the new map, blue: in the old"},
                 .image = ChartImage{.values = grid, .diverging = true}};
  };
  figure.sheet = {.heading = "Figure 3: the overlap of two partial maps",
                  .charts = {chart("(a) by odometry", before, pair.prior), chart("(b) corrected", after, found)},
                  .columns = 2,
                  .note = "32 x 64 cells of 0.25 m; the robot stands in the middle of the left side and looks right"};
  return figure;
}

LabFigure figure_flow(const SenseFigureConfig& /*config*/, Workers& /*workers*/, const LabProgress& /*progress*/) {
  const Pair pair = pair_of_looks();
  const GridFrame& frame = pair.first.map.occupancy.frame();
  const Pose2 flow = pair.second.offset->T_first_second * pair.prior.inverse();  // of points seen from the first pose
  LabFigure figure{.csv = "x_m,y_m,flow_x_m,flow_y_m\n"};
  Series points{.name = "a cell of the new map, by odometry", .style = SeriesStyle::kPointsOnly, .look = 0};
  Chart chart{.title = fmt::format("shift ({:.2f}, {:.2f}) m and turn {:.2f} deg for all points", flow.x, flow.y,
                                   degrees(flow.theta)),
              .x = {.label = "ahead [m]"},
              .y = {.label = "to the left [m]"}};
  for (int y = 0; y < frame.height; y += 2) {
    for (int x = 0; x < frame.width; x += 2) {
      if (pair.first.map.weight[{x, y}] <= 0.0) continue;
      const Eigen::Vector2d from = frame.centre_of({x, y}), to = flow * from, drawn = from + kDrawnTimes * (to - from);
      figure.csv += fmt::format("{},{},{},{}\n", from.x(), from.y(), to.x() - from.x(), to.y() - from.y());
      points.x.push_back(from.x());
      points.y.push_back(from.y());
      chart.series.push_back(
          {.x = {from.x(), drawn.x()}, .y = {from.y(), drawn.y()}, .style = SeriesStyle::kLineOnly, .look = 1});
    }
  }
  if (!chart.series.empty()) chart.series.front().name = "where it moves by the offset";
  chart.series.push_back(points);
  figure.sheet = {.heading = fmt::format("Figure 4: motion of points by the offset, {} times as long", kDrawnTimes),
                  .charts = {chart},
                  .note = "One rigid motion is fitted to all points at once"};
  return figure;
}

}  // namespace cogslam
