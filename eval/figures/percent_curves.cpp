#include "eval/figures/percent_curves.hpp"

namespace cogslam {
namespace {

bool has_poses(const EpisodeRow& row, bool true_poses) {
  return (row.number("true_poses").value_or(0.0) != 0.0) == true_poses;
}

}  // namespace

RowNumber percent_kept() {
  return [](const EpisodeRow& row) -> std::optional<double> { return row.number("percent_kept").value_or(100.0); };
}

std::vector<CurveRows> recovery_rows(const EpisodeTable& table, const std::vector<RecoveryCurve>& curves,
                                     bool true_poses) {
  std::vector<CurveRows> all;
  for (const RecoveryCurve& curve : curves) {
    all.push_back({.name = curve.name, .table = &table, .look = curve.look});
    all.back().takes = [curve, true_poses](const EpisodeRow& row) {
      return row.text("compressor") == curve.compressor && row.text("recovery") == curve.recovery &&
             has_poses(row, true_poses);
    };
  }
  return all;
}

CurvePanel percent_panel(const std::string& title, const std::string& score, const ChartAxis& y_axis,
                         const std::vector<CurveRows>& curves) {
  CurvePanel panel;
  panel.title = title;
  panel.x_axis = {.label = "% of the data (OG: 100)", .min = 0.0, .max = 100.0};
  panel.y_axis = y_axis;
  panel.x = percent_kept();
  panel.y = column(score);
  panel.curves = curves;
  return panel;
}

CurveRows og_rows(const EpisodeTable& table, bool true_poses) {
  CurveRows rows{.name = "OG", .table = &table, .look = 0, .style = SeriesStyle::kPointsOnly};
  rows.takes = [true_poses](const EpisodeRow& row) {
    return row.text("store") == "dense" && has_poses(row, true_poses);
  };
  return rows;
}

}  // namespace cogslam
