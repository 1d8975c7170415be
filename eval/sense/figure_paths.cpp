// Figures 2 and 7 to 9: the hallway, and its partial maps laid out by true poses, by odometry and by corrected poses.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "eval/sense/figure.hpp"
#include "eval/sense/hallway_study.hpp"
#include "eval/sense/map_quality.hpp"
#include "slam/mobile_sensing/stitch.hpp"
#include "worlds/hallway.hpp"
#include "worlds/truth_grid.hpp"

namespace cogslam {
namespace {

constexpr double kCellSize = 0.25;  // [m]
constexpr std::uint32_t kSeed = 1;

std::vector<Pose2> poses_of(const HallwayRun& run, int figure) {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < run.looks.size(); ++i) {
    poses.push_back(figure == 7   ? run.looks[i].T_map_base
                    : figure == 8 ? run.looks[i].T_odom_base
                                  : run.corrected[i].T_map_base);
  }
  return poses;
}

/// Grows `area` by the cells that a partial map knows.
void add_known(Rectangle& area, const PartialMap& map, const Pose2& T_map_base) {
  const GridFrame& frame = map.weight.frame();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (map.weight[{x, y}] <= 0.0) continue;
      const Eigen::Vector2d p = T_map_base * frame.centre_of({x, y});
      area = {area.min.cwiseMin(p), area.max.cwiseMax(p)};
    }
  }
}

/// What the pictures show, alike for all poses: the hallway, and all that is known by any of them.
GridFrame shown(const HallwayRun& run) {
  Rectangle area = hallway().bounds();
  for (const int figure : {7, 8, 9}) {
    const std::vector<Pose2> poses = poses_of(run, figure);
    for (std::size_t i = 0; i < poses.size(); ++i) add_known(area, run.corrected[i].map, poses[i]);
  }
  return GridFrame::covering(area, kCellSize, 1);
}

Grid<double> stitched(const HallwayRun& run, const std::vector<Pose2>& poses) {
  Grid<double> log_odds(shown(run));
  for (std::size_t i = 0; i < poses.size(); ++i) stitch(log_odds, run.corrected[i].map, poses[i]);
  return probability(log_odds);
}

/// Of the cells of figure 2; those that no partial map knows have 0.5.
MapQuality quality_of(const Grid<double>& map) {
  const GridFrame field = truth_grid(hallway(), kCellSize).frame();
  std::vector<double> cells;
  for (int y = field.height; y-- > 0;) {
    for (int x = 0; x < field.width; ++x) cells.push_back(map[map.frame().cell_of(field.centre_of({x, y}))]);
  }
  return map_quality(hallway_field().cells, cells);
}

Grid<float> picture_of(const Grid<double>& map) {
  Grid<float> picture(map.frame());
  std::ranges::transform(map.values(), picture.values().begin(), [](double p) { return static_cast<float>(p); });
  return picture;
}

}  // namespace

LabFigure figure_hallway(const SenseFigureConfig& /*config*/, Workers& /*workers*/, const LabProgress& /*progress*/) {
  const FieldMap field = hallway_field();
  Grid<float> map({.width = field.width, .height = field.height});
  LabFigure figure{.csv = "x,y,occupancy\n"};
  for (std::size_t i = 0; i < field.cells.size(); ++i) {
    const int x = static_cast<int>(i) % field.width, y = field.height - 1 - static_cast<int>(i) / field.width;
    map[{x, y}] = static_cast<float>(field.cells[i]);
    figure.csv += fmt::format("{},{},{}\n", x, y, field.cells[i]);
  }
  figure.sheet = {.heading = "Figure 2: the hallway, every cell known",
                  .charts = {{.title = fmt::format("{} x {} cells of {} m", field.width, field.height, kCellSize),
                              .x = {.label = "white: free, black: wall, grey: out of reach"},
                              .image = ChartImage{.values = std::move(map)}}}};
  return figure;
}

LabFigure figure_stitched(int number) {
  const PathDriveConfig drive{};
  const PathCorrectionConfig correction{};
  const HallwayRun run = run_hallway(drive, correction, kSeed);
  const std::vector<Pose2> poses = poses_of(run, number);
  const PathDeviation error = path_deviation(run.looks, poses);
  const char* by = number == 7 ? "true poses" : number == 8 ? "odometry" : "corrected poses";
  LabFigure figure{.csv = "look,x_m,y_m,heading_deg,true_x_m,true_y_m,true_heading_deg\n"};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2& truth = run.looks[i].T_map_base;
    figure.csv += fmt::format("{},{},{},{},{},{},{}\n", i, poses[i].x, poses[i].y, degrees(poses[i].theta), truth.x,
                              truth.y, degrees(truth.theta));
  }
  const Grid<double> map = stitched(run, poses);
  figure.sheet = {.heading = fmt::format("Figure {}: {} partial maps stitched by {}", number, poses.size(), by),
                  .charts = {{.title = fmt::format("rms: heading {:.2f} deg, across {:.2f} m, along {:.2f} m",
                                                   degrees(error.heading), error.across, error.along),
                              .x = {.label = quality_line(quality_of(map))},
                              .image = ChartImage{.values = picture_of(map)}}},
                  .note = fmt::format("{} of {} cells, a map every {} m, seed {}; truth: figure 2", correction.samples,
                                      correction.map.cells(), drive.step_m, kSeed)};
  return figure;
}

}  // namespace cogslam
