#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "eval/lab/figure.hpp"
#include "eval/lab/seeds.hpp"
#include "eval/sense/field_map.hpp"

namespace cogslam {

/// How the figures of compressive mobile sensing are made.
struct SenseFigureConfig {
  std::optional<FieldMap> map;  ///< the field of figures 5 and 6; nothing: hallway_field()
  int seeds = 10;               ///< draws of cells behind every mean, >= 2
};

/// A figure of the paper, made anew.
struct SenseFigure {
  int number = 0;
  std::string shows;  ///< for people, in a line
  std::function<LabFigure(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress)> make;
};

/// Every figure there is, by number. Each lives in a file of its own, is declared below, and adds itself here.
const std::vector<SenseFigure>& sense_figures();

/// The one of this number; InputError, with all there are, for others.
const SenseFigure& sense_figure(int number);

// One file each.
LabFigure figure_hallway(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress);     // 2
LabFigure figure_overlap(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress);     // 3
LabFigure figure_flow(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress);        // 4
LabFigure figure_stitched(int number);                                                                        // 7, 8, 9
LabFigure figure_by_samples(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress);  // 5
LabFigure figure_by_prior(const SenseFigureConfig& config, Workers& workers, const LabProgress& progress);    // 6

}  // namespace cogslam
