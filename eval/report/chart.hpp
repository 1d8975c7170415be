#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/grid.hpp"

// Line charts as SVG and as PNG, both from one layout. Points that are not finite, and on a logarithmic axis those not
// above zero, leave a gap. The same data give the same bytes.

namespace cogslam {

enum class SeriesStyle {
  kLine,      ///< a line with a marker at each point
  kLineOnly,  ///< a line alone, for dense curves
  kStems,     ///< a bar from zero to each point, as for the coefficients of a signal
  kPointsOnly,
};

/// One curve: `x` and `y` of one length; `low` and `high` of the same length (a band, as a 95 % interval) or empty.
struct Series {
  std::string name;  ///< in the legend; an empty one is left out of it
  std::vector<double> x, y;
  std::vector<double> low{}, high{};
  SeriesStyle style = SeriesStyle::kLine;
  std::optional<int> look{};  ///< colour and marker, 0 to 6; nothing: its place among the series
};

struct ChartAxis {
  std::string label;  ///< with its unit
  bool log = false;
  std::optional<double> min{}, max{};  ///< nothing: from the data
};

/// A grid shown as a picture in place of curves: the least value white, the greatest black, or for `diverging` white at
/// zero, blue below and vermilion above.
struct ChartImage {
  Grid<float> values;
  bool diverging = false;
  bool y_down = false;  ///< the first row on top, as a matrix; else at the bottom, as a map
};

struct Chart {
  std::string title;
  ChartAxis x, y;
  std::vector<Series> series;
  std::optional<ChartImage> image{};
};

/// Charts side by side, `columns` to a row, under one heading.
struct ChartSheet {
  std::string heading;
  std::vector<Chart> charts;
  int columns = 1;
  std::string note{};  ///< one line below
};

std::string chart_svg(const ChartSheet& sheet);
std::string chart_png(const ChartSheet& sheet);

}  // namespace cogslam
