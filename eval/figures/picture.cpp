#include "eval/figures/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/number_text.hpp"
#include "eval/metrics/map_error.hpp"

namespace cogslam {
namespace {

constexpr double kMargin = 0.2;       // [m] around the world
constexpr double kFieldShape = 1.82;  // width of a chart's field over its height (eval/report/chart_plot.hpp)

/// Every surface as a stretch of one curve.
Series surfaces(const World& world) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  Series series{.name = "walls", .style = SeriesStyle::kLineOnly, .look = 0};
  for (const Segment& s : world.segments()) {
    series.x.insert(series.x.end(), {s.a.x(), s.b.x(), kGap});
    series.y.insert(series.y.end(), {s.a.y(), s.b.y(), kGap});
  }
  return series;
}

void fit_axes(const Rectangle& bounds, Chart& chart) {
  const Eigen::Vector2d centre = (bounds.min + bounds.max) / 2.0, size = bounds.max - bounds.min;
  const double height = std::max(size.y() + 2.0 * kMargin, (size.x() + 2.0 * kMargin) / kFieldShape);
  chart.x = {
      .label = "x [m]", .min = centre.x() - kFieldShape * height / 2.0, .max = centre.x() + kFieldShape * height / 2.0};
  chart.y = {.label = "y [m]", .min = centre.y() - height / 2.0, .max = centre.y() + height / 2.0};
}

}  // namespace

Chart path_chart(const std::string& title, const World& world, const std::vector<NamedPath>& paths) {
  constexpr std::array kLooks{6, 4, 1, 2, 3};
  Chart chart;
  chart.title = title;
  fit_axes(world.bounds(), chart);
  chart.series.push_back(surfaces(world));
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Series& series = chart.series.emplace_back();
    series = {.name = paths[i].name, .style = SeriesStyle::kLineOnly, .look = kLooks.at(i % kLooks.size())};
    for (const Pose2& pose : paths[i].poses) {
      series.x.push_back(pose.x);
      series.y.push_back(pose.y);
    }
  }
  return chart;
}

Chart map_chart(const std::string& title, const std::string& below, const Grid<float>& log_odds) {
  Chart chart;
  chart.title = title;
  chart.x.label = below;
  chart.image = ChartImage{.values = Grid<float>(log_odds.frame())};
  std::transform(log_odds.values().begin(), log_odds.values().end(), chart.image->values.values().begin(),
                 [](float l) { return static_cast<float>(scored_probability(l)); });
  return chart;
}

std::string path_csv(const NamedPath& path) {
  std::string out;
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    out +=
        fmt::format("path,{},{},,,{},{},\n", path.name, i, number_text(path.poses[i].x), number_text(path.poses[i].y));
  }
  return out;
}

std::string map_csv(const std::string& name, const Grid<float>& log_odds) {
  std::string out;
  const GridFrame& frame = log_odds.frame();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double p = scored_probability(log_odds[{x, y}]);
      out += fmt::format("map,{},,{},{},{},{},{}\n", name, y, x,
                         number_text((frame.lattice_min.x + x + 0.5) * frame.cell_size),
                         number_text((frame.lattice_min.y + y + 0.5) * frame.cell_size), number_text(p));
    }
  }
  return out;
}

std::vector<Pose2> true_path(const TruthLog& truth) {
  std::vector<Pose2> path;
  for (const TruePose& pose : truth.poses) path.push_back(pose.T_map_base);
  return path;
}

}  // namespace cogslam
