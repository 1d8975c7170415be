#include "eval/sense/figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace cogslam {

const std::vector<SenseFigure>& sense_figures() {
  static const std::vector<SenseFigure> kFigures{
      {5, "a field from few of its cells by total variation, and how that goes with K", figure_by_samples},
      {6, "the same from sparsity in DCT and in Haar", figure_by_prior},
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

const FieldMap& field_of(const SenseFigureConfig& config, int number) {
  if (!config.map) throw InputError(fmt::format("figure {} needs a field: give one with --map FILE", number));
  return *config.map;
}

}  // namespace cogslam
