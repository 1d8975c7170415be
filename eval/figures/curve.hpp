#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "eval/lab/figure.hpp"
#include "eval/stats.hpp"
#include "eval/sweep/database.hpp"

// From the rows of sweeps to curves: a point for each variant, a mean over its seeds.

namespace cogslam {

/// One episode of a table.
struct EpisodeRow {
  const EpisodeTable& table;
  std::size_t index = 0;

  [[nodiscard]] std::optional<double> number(const std::string& column) const { return table.number(index, column); }
  [[nodiscard]] std::string text(const std::string& column) const { return table.text(index, column); }
};

using RowNumber = std::function<std::optional<double>(const EpisodeRow&)>;
using RowChoice = std::function<bool(const EpisodeRow&)>;

/// The number in a column, times `unit`.
RowNumber column(const std::string& name, double unit = 1.0);

/// The rows that make one curve, out of one table.
struct CurveRows {
  std::string name;
  const EpisodeTable* table = nullptr;
  RowChoice takes;
  std::optional<int> look{};  ///< colour and marker, as in Series
  SeriesStyle style = SeriesStyle::kLine;
};

/// A variant of a curve: where it lies, and the mean over its episodes.
struct CurvePoint {
  std::string world;
  std::string variant;
  double x = 0.0;  ///< mean over the seeds
  MeanInterval y{};
};

/// A point for each world, cell size and variant among the rows that have both numbers; ascending by x.
std::vector<CurvePoint> curve_points(const CurveRows& rows, const RowNumber& x, const RowNumber& y);

/// A chart of curves and what its points show.
struct CurvePanel {
  std::string title;
  ChartAxis x_axis, y_axis;
  RowNumber x, y;
  std::vector<CurveRows> curves;
};

/// Charts with 95 % bands, and a CSV line for each point. On a logarithmic axis with a stated minimum, values below it
/// lie on it, zero among them.
LabFigure curve_figure(const std::string& heading, const std::vector<CurvePanel>& panels, int columns,
                       const std::string& note);

/// The series of points that were already taken together.
Series series_of(const std::string& name, const std::vector<CurvePoint>& points, const ChartAxis& y_axis);

/// "3 seeds", "3 to 30 seeds": of all points of these panels.
std::string seeds_text(const std::vector<CurvePanel>& panels);

}  // namespace cogslam
