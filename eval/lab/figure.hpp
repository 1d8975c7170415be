#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "eval/lab/seeds.hpp"
#include "eval/lab/signal_study.hpp"
#include "eval/report/chart.hpp"

namespace cogslam {

/// A figure of the paper, made anew: its numbers and its picture.
struct LabFigure {
  std::string csv;
  ChartSheet sheet;
};

/// How figures are made.
struct FigureConfig {
  int seeds = 30;  ///< random compression matrices behind every mean
};

inline constexpr int kFirstFigure = 1, kLastFigure = 11;

/// Figure `number` of the paper, 1 to 11. Its numbers are the same for any number of threads, but for the times of
/// figures 8 and 11.
LabFigure lab_figure(int number, const FigureConfig& config, Workers& workers, const LabProgress& progress);

/// The same from the study behind both figures, 7 and 8, where it has already been run.
LabFigure figure_mse_by_percent(const SignalStudy& study, const std::vector<SignalScore>& scores);   // 7
LabFigure figure_time_by_percent(const SignalStudy& study, const std::vector<SignalScore>& scores);  // 8
SignalStudy comparison_study(const FigureConfig& config);

/// Writes figure_01.csv, .svg and .png into a folder, made where it does not exist.
void write_figure(const std::filesystem::path& folder, int number, const LabFigure& figure);

// One file each.
LabFigure figure_test_signal();  // 1
LabFigure figure_recoveries(int number, const FigureConfig& config, Workers& workers,
                            const LabProgress& progress);                                                     // 2 to 5
LabFigure figure_mse_by_p(const FigureConfig& config, Workers& workers, const LabProgress& progress);         // 6
LabFigure figure_example_grid();                                                                              // 9
LabFigure figure_grid_recoveries(const FigureConfig& config, Workers& workers, const LabProgress& progress);  // 10
LabFigure figure_l2_times(const LabProgress& progress);                                                       // 11

/// The grid of figures 9 and 10: the ideal map of the simple room in 0.06 m cells, in the middle of 64 x 64 cells.
Grid<float> example_grid();

}  // namespace cogslam
