#include "eval/figures/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/number_text.hpp"

namespace cogslam {
namespace {

struct PointValues {
  std::vector<double> x, y;
};

double mean(const std::vector<double>& values) { return mean_interval(values).mean; }

/// On a logarithmic axis what cannot be shown lies at its end.
double shown(double value, const ChartAxis& axis) {
  return axis.log && axis.min && std::isfinite(value) ? std::max(value, *axis.min) : value;
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

}  // namespace

RowNumber column(const std::string& name, double unit) {
  return [name, unit](const EpisodeRow& row) -> std::optional<double> {
    const auto value = row.number(name);
    if (!value) return std::nullopt;
    return unit * *value;
  };
}

std::vector<CurvePoint> curve_points(const CurveRows& rows, const RowNumber& x, const RowNumber& y) {
  std::map<std::tuple<std::string, double, std::string>, PointValues> groups;
  for (std::size_t i = 0; i < rows.table->rows.size(); ++i) {
    const EpisodeRow row{*rows.table, i};
    if (!rows.takes(row)) continue;
    const auto at = x(row), value = y(row);
    if (!at || !value) continue;
    PointValues& group = groups[{row.text("world"), row.number("cell_size_m").value_or(0.0), row.text("variant")}];
    group.x.push_back(*at);
    group.y.push_back(*value);
  }
  std::vector<CurvePoint> points;
  for (const auto& [key, values] : groups) {
    points.push_back({std::get<0>(key), std::get<2>(key), mean(values.x), mean_interval(values.y)});
  }
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return points;
}

Series series_of(const std::string& name, const std::vector<CurvePoint>& points, const ChartAxis& y_axis) {
  Series series{.name = name};
  for (const CurvePoint& point : points) {
    series.x.push_back(point.x);
    series.y.push_back(shown(point.y.mean, y_axis));
    series.low.push_back(shown(point.y.low(), y_axis));
    series.high.push_back(shown(point.y.high(), y_axis));
  }
  return series;
}

LabFigure curve_figure(const std::string& heading, const std::vector<CurvePanel>& panels, int columns,
                       const std::string& note) {
  LabFigure figure{.csv = "panel,quantity,curve,world,variant,x,seeds,mean,low95,high95\n",
                   .sheet = {.heading = heading, .columns = columns, .note = note}};
  for (const CurvePanel& panel : panels) {
    Chart& chart = figure.sheet.charts.emplace_back();
    chart.title = panel.title;
    chart.x = panel.x_axis;
    chart.y = panel.y_axis;
    for (const CurveRows& curve : panel.curves) {
      const std::vector<CurvePoint> points = curve_points(curve, panel.x, panel.y);
      if (points.empty()) continue;
      chart.series.push_back(series_of(curve.name, points, panel.y_axis));
      chart.series.back().style = curve.style;
      chart.series.back().look = curve.look;
      for (const CurvePoint& point : points) {
        const bool spread = point.y.count > 1;
        figure.csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", quoted(panel.title), quoted(panel.y_axis.label),
                                  quoted(curve.name), point.world, point.variant, number_text(point.x), point.y.count,
                                  number_text(point.y.mean), spread ? number_text(point.y.low()) : "",
                                  spread ? number_text(point.y.high()) : "");
      }
    }
  }
  return figure;
}

std::string seeds_text(const std::vector<CurvePanel>& panels) {
  std::size_t least = 0, most = 0;
  for (const CurvePanel& panel : panels) {
    for (const CurveRows& curve : panel.curves) {
      for (const CurvePoint& point : curve_points(curve, panel.x, panel.y)) {
        least = least == 0 ? point.y.count : std::min(least, point.y.count);
        most = std::max(most, point.y.count);
      }
    }
  }
  if (least == most) return most == 1 ? "1 seed" : fmt::format("{} seeds", most);
  return fmt::format("{} to {} seeds", least, most);
}

}  // namespace cogslam
