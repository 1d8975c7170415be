#include "eval/sense/figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace cogslam {

namespace {

auto stitched_by(int number) {
  return [number](const SenseFigureConfig&, Workers&, const LabProgress&) { return figure_stitched(number); };
}

}  // namespace

const std::vector<SenseFigure>& sense_figures() {
  static const std::vector<SenseFigure> kFigures{
      {2, "the hallway, every cell known", figure_hallway},
      {3, "the overlap of two partial maps before and after their offset is known", figure_overlap},
      {4, "the motion of points between them", figure_flow},
      {5, "a field from few of its cells by total variation, and how that goes with K", figure_by_samples},
      {6, "the same from sparsity in DCT and in Haar", figure_by_prior},
      {7, "partial maps of the hallway stitched by true poses", stitched_by(7)},
      {8, "the same by odometry", stitched_by(8)},
      {9, "the same by corrected poses", stitched_by(9)},
  };
  return kFigures;
}

const SenseFigure& sense_figure(int number) {
  const std::vector<SenseFigure>& all = sense_figures();
  const auto found = std::ranges::find(all, number, &SenseFigure::number);
  if (found != all.end()) return *found;
  std::vector<int> numbers;
  for (const SenseFigure& figure : all) numbers.push_back(figure.number);
  throw InputError(fmt::format("no figure {}, expected one of {}", number, fmt::join(numbers, ", ")));
}

}  // namespace cogslam
