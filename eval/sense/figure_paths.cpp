// Figures 2 and 7 to 9: the hallway, and its partial maps laid out by true poses, by odometry and by corrected poses.
#include <fmt/format.h>

#include "eval/sense/figure.hpp"
#include "eval/sense/hallway_study.hpp"
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

/// What the pictures show: the hallway and a little around it, alike for all poses; what lies farther out is cut off.
GridFrame shown() { return GridFrame::covering(hallway().bounds(), kCellSize, 8); }

Grid<float> stitched(const HallwayRun& run, const std::vector<Pose2>& poses) {
  Grid<double> log_odds(shown());
  for (std::size_t i = 0; i < poses.size(); ++i) stitch(log_odds, run.corrected[i].map, poses[i]);
  Grid<float> out(log_odds.frame());
  const Grid<double> p = probability(log_odds);
  for (std::size_t i = 0; i < out.values().size(); ++i) out.values()[i] = static_cast<float>(p.values()[i]);
  return out;
}

}  // namespace

LabFigure figure_hallway(const SenseFigureConfig& /*config*/, Workers& /*workers*/, const LabProgress& /*progress*/) {
  const Grid<TruthCell> truth = truth_grid(hallway(), kCellSize);
  Grid<float> map(truth.frame());
  LabFigure figure{.csv = "x,y,occupancy\n"};
  for (int y = 0; y < map.frame().height; ++y) {
    for (int x = 0; x < map.frame().width; ++x) {
      const TruthCell cell = truth[{x, y}];
      map[{x, y}] = cell == TruthCell::kFree ? 0.0F : cell == TruthCell::kOccupied ? 1.0F : 0.5F;
      figure.csv += fmt::format("{},{},{}\n", x, y, map[{x, y}]);
    }
  }
  figure.sheet = {
      .heading = "Figure 2: the hallway, every cell known",
      .charts = {{.title = fmt::format("{} x {} cells of {} m", map.frame().width, map.frame().height, kCellSize),
                  .x = {.label = "white: free, black: wall, grey: out of reach"},
                  .image = ChartImage{.values = map}}}};
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
  figure.sheet = {
      .heading = fmt::format("Figure {}: {} partial maps stitched by {}", number, poses.size(), by),
      .charts = {{.title = fmt::format("rms: heading {:.2f} deg, across {:.2f} m, along {:.2f} m",
                                       degrees(error.heading), error.across, error.along),
                  .x = {.label = fmt::format("{} of {} cells sampled, every {} m, seed {}", correction.samples,
                                             correction.map.cells(), drive.step_m, kSeed)},
                  .image = ChartImage{.values = stitched(run, poses)}}}};
  return figure;
}

}  // namespace cogslam
