#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "eval/figures/measured_sweep.hpp"
#include "eval/lab/figure.hpp"

namespace cogslam {

/// What a figure may use.
struct FigureInputs {
  const std::map<std::string, MeasuredSweep>& sweeps;  ///< by name; at least those that the figure names
  Workers& workers;
  LabProgress progress;

  [[nodiscard]] const MeasuredSweep& sweep(const std::string& name) const { return sweeps.at(name); }
};

/// A figure of experiments in the filter: section 6 of Cain and Leonessa, or one that the paper lacks.
struct ExperimentFigure {
  std::string name;                 ///< "12": the paper's number; else a word
  std::string shows;                ///< for people, in a line
  std::vector<std::string> sweeps;  ///< scenarios/sweeps/<name>.yaml that it is drawn from
  std::function<LabFigure(const FigureInputs&)> make;
  bool asked_only = false;  ///< takes long: left out where no figure is named
};

/// Every figure there is; each lives in a file of its own, is declared below, and stands in this list.
const std::vector<ExperimentFigure>& experiment_figures();

/// The one of this name; InputError, with all there are, for others.
const ExperimentFigure& experiment_figure(const std::string& name);

/// Writes figure_<name>.csv, .svg and .png into a folder, made where it does not exist.
void write_experiment_figure(const std::filesystem::path& folder, const ExperimentFigure& which,
                             const LabFigure& figure);

// One file each.
LabFigure figure_baseline(const FigureInputs& inputs);                                   // 12
LabFigure figure_l2_path_and_map(const FigureInputs& inputs);                            // 13
LabFigure figure_cs_path_and_map(const FigureInputs& inputs);                            // 14
LabFigure figure_mse_by_percent_kept(const FigureInputs& inputs);                        // 15
LabFigure figure_mse_by_percent_kept_matched(const FigureInputs& inputs);                // 15 with our filter
LabFigure figure_l2_map_series(const FigureInputs& inputs);                              // 16
LabFigure figure_cs_map_series(const FigureInputs& inputs);                              // 17
LabFigure figure_step_time(const FigureInputs& inputs);                                  // 18
LabFigure figure_room_map(const FigureInputs& inputs, const std::string& room);          // 19, 21, 23
LabFigure figure_room_compression(const FigureInputs& inputs, const std::string& room);  // 20, 22, 24
LabFigure figure_error_by_bytes(const FigureInputs& inputs);
LabFigure figure_error_by_particles(const FigureInputs& inputs);
LabFigure figure_forty_percent(const FigureInputs& inputs);

}  // namespace cogslam
