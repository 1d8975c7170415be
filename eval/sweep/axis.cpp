#include "eval/sweep/axis.hpp"

#include <sstream>

#include "core/number_text.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMostPoints = 10'000;

SweepAxis read_axis(ConfigSection entry) {
  SweepAxis axis;
  entry.read("key", axis.key);
  if (axis.key.empty()) entry.fail("key", "key: expected the key of a scenario, like slam.store.percent_kept");
  entry.read("label", axis.label);
  axis.place = entry.place("key");
  std::vector<double> numbers;
  std::string words;
  entry.read("values", numbers);
  entry.read("words", words);
  for (const double number : numbers) axis.values.push_back(number_text(number));
  std::istringstream in(words);
  for (std::string word; in >> word;) axis.values.push_back(word);
  if (axis.values.empty() || (!numbers.empty() && !words.empty())) {
    entry.fail("key", axis.key + ": expected either `values: [1, 2, ...]` or `words: one two ...`");
  }
  return axis;
}

}  // namespace

std::vector<SweepAxis> read_axes(ConfigSection& section) {
  std::vector<SweepAxis> axes;
  std::size_t points = 1;
  for (ConfigSection& entry : section.sections("each")) {
    axes.push_back(read_axis(entry));
    points *= axes.back().values.size();
    if (points > kMostPoints) {
      entry.fail("key", axes.back().key + ": too many combinations, expected at most " + std::to_string(kMostPoints));
    }
  }
  return axes;
}

std::vector<AxisPoint> axis_points(const std::vector<SweepAxis>& axes) {
  std::vector<AxisPoint> points(1);
  for (const SweepAxis& axis : axes) {
    std::vector<AxisPoint> finer;
    for (const AxisPoint& point : points) {
      for (const std::string& value : axis.values) {
        finer.push_back(point);
        finer.back().settings.emplace_back(axis.key, value);
        finer.back().suffix += axis.label + value;
      }
    }
    points = std::move(finer);
  }
  return points;
}

void with_axis_places(const std::vector<SweepAxis>& axes, const std::function<void()>& use) {
  constexpr std::string_view kOption = "--set ";  // how the reader calls a value that no file states
  try {
    use();
  } catch (const InputError& error) {
    const std::string what = error.what();
    for (const SweepAxis& axis : axes) {
      if (what.starts_with(std::string(kOption) + axis.key + "=")) {
        throw InputError(axis.place, "each " + what.substr(kOption.size()));
      }
    }
    throw;
  }
}

}  // namespace cogslam
