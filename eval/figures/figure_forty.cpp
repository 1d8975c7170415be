// What the paper lacks: how much of the data is enough, over the size of the room and with unbounded log-odds.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/number_text.hpp"
#include "eval/figures/curve.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/percent_curves.hpp"
#include "eval/figures/thresholds.hpp"

namespace cogslam {
namespace {

constexpr double kGoodMse = 1e-4;  // of probability, beside OG's map: no cell in a hundred is off by more than 0.1

struct Room {
  const char* world;
  const char* title;
};
constexpr std::array kRooms{Room{"small", "3.0 x 3.7 m, empty (paper)"}, Room{"four_times", "6.1 x 7.3 m, empty"},
                            Room{"sixteen_times", "12 x 15 m, empty"}, Room{"cluttered", "5.1 x 6.1 m, boxes"}};

std::vector<CurveRows> room_rows(const EpisodeTable& table, bool clamped) {
  std::vector<CurveRows> all;
  for (const Room& room : kRooms) {
    all.push_back({.name = room.title, .table = &table});
    all.back().takes = [world = fmt::format("{}_clamped_{}", room.world, clamped)](const EpisodeRow& row) {
      return row.text("world") == world && row.text("store") == "coefficients";
    };
  }
  return all;
}

CurvePanel panel_of(const EpisodeTable& table, bool clamped) {
  return {clamped ? "(a) log-odds clamped to [-2, 3.2]" : "(b) log-odds unbounded, as the paper writes them",
          {.label = "% of the data", .log = true, .min = 1.0, .max = 100.0},
          {.label = "grid MSE beside OG's (probability)", .log = true, .min = 1e-12, .max = 1.0},
          percent_kept(),
          column("grid_mse_vs_baseline"),
          room_rows(table, clamped)};
}

std::string enough_text(const CurvePanel& panel, std::string& csv) {
  std::string text;
  for (const CurveRows& rows : panel.curves) {
    const auto enough = least_within(curve_points(rows, panel.x, panel.y), kGoodMse);
    text += (text.empty() ? "" : ", ") + (enough ? number_text(*enough) : "over 100");
    csv += fmt::format("\"enough: {}\",% of the data,\"{}\",,,,,{},,\n", panel.title, rows.name,
                       enough ? number_text(*enough) : "");
  }
  return text;
}

}  // namespace

LabFigure figure_forty_percent(const FigureInputs& inputs) {
  const EpisodeTable& table = inputs.sweep("forty_percent").table;
  const std::vector<CurvePanel> panels{panel_of(table, true), panel_of(table, false)};
  LabFigure figure = curve_figure("40 % revisited: the map kept in the loop, from true poses", panels, 2, "");
  const std::string clamped = enough_text(panels[0], figure.csv), unbounded = enough_text(panels[1], figure.csv);
  figure.sheet.note =
      fmt::format("Cells of 0.1 m, mean of {}. Enough for an MSE of {}, in the order of the legend: (a) {} %, (b) {} %",
                  seeds_text(panels), kGoodMse, clamped, unbounded);
  return figure;
}

}  // namespace cogslam
