#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "eval/figures/curve.hpp"
#include "eval/figures/experiment_figure.hpp"
#include "eval/figures/pareto.hpp"
#include "eval/figures/percent_curves.hpp"
#include "eval/figures/picture.hpp"
#include "eval/figures/thresholds.hpp"
#include "eval/sweep/columns.hpp"

namespace cogslam {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// An empty table with the columns that a sweep's has.
EpisodeTable empty_table() {
  EpisodeTable table;
  for (const EpisodeColumn& column : episode_columns()) table.columns.emplace_back(column.name);
  return table;
}

using Values = std::map<std::string, TableValue>;

void add_row(EpisodeTable& table, const Values& values) {
  std::vector<TableValue>& row = table.rows.emplace_back();
  for (const std::string& column : table.columns) {
    const auto found = values.find(column);
    row.push_back(found == values.end() ? TableValue{} : found->second);
  }
}

void add_coefficients(EpisodeTable& table, const std::string& recovery, double percent, std::int64_t seed, double mse,
                      bool true_poses = false) {
  add_row(table, {{"world", std::string("simple")},
                  {"cell_size_m", 0.1},
                  {"variant", recovery + "_" + std::to_string(static_cast<int>(percent))},
                  {"seed", seed},
                  {"store", std::string("coefficients")},
                  {"compressor", std::string("top_m")},
                  {"recovery", recovery},
                  {"percent_kept", percent},
                  {"true_poses", std::int64_t{true_poses}},
                  {"path_mse_vs_baseline_m2", mse}});
}

/// l2 at 40 % (two seeds) and 10 % (one), CS at 40 %, and rows that belong to no such curve.
EpisodeTable invented_table() {
  EpisodeTable table = empty_table();
  add_coefficients(table, "fast_l2", 40, 1, 1.0);
  add_coefficients(table, "fast_l2", 40, 2, 3.0);
  add_coefficients(table, "fast_l2", 10, 1, 7.0);
  add_coefficients(table, "nesta", 40, 1, 0.0);
  add_coefficients(table, "fast_l2", 40, 1, 100.0, true);
  add_row(table, {{"store", std::string("dense")}, {"true_poses", std::int64_t{0}}});
  return table;
}

CurveRows l2_rows(const EpisodeTable& table) { return recovery_rows(table, {kTopL2}, false).front(); }

TEST(Curve, IsAMeanOverSeedsAtEachVariantByPercent) {
  const EpisodeTable table = invented_table();
  const auto points = curve_points(l2_rows(table), percent_kept(), column("path_mse_vs_baseline_m2", 10.0));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].variant, "fast_l2_10");
  EXPECT_EQ(points[0].x, 10.0);
  EXPECT_EQ(points[0].y.count, 1u);
  EXPECT_EQ(points[0].y.mean, 70.0);
  EXPECT_EQ(points[1].x, 40.0);
  EXPECT_EQ(points[1].y.count, 2u);
  EXPECT_EQ(points[1].y.mean, 20.0);
  // Student's t for one degree of freedom is 12.706; the standard error of {10, 30} is 10.
  EXPECT_NEAR(points[1].y.half_width, 127.06, 0.01);
}

TEST(Curve, LeavesOutRowsWithoutTheNumber) {
  const EpisodeTable table = invented_table();
  EXPECT_TRUE(curve_points(l2_rows(table), percent_kept(), column("grid_mse")).empty());
  EXPECT_TRUE(curve_points(og_rows(table, false), percent_kept(), column("path_mse_vs_baseline_m2")).empty());
}

CurvePanel small_panel(const EpisodeTable& table) {
  CurvePanel panel;
  panel.title = "path";
  panel.x_axis.label = "%";
  panel.y_axis = {.label = "MSE [m2]", .log = true, .min = 1e-9, .max = 10.0};
  panel.x = percent_kept();
  panel.y = column("path_mse_vs_baseline_m2");
  panel.curves = recovery_rows(table, {kTopL2, kTopCs, kHadamardCs}, false);
  return panel;
}

TEST(Curve, FigureStatesEveryPointAndItsSeedsInTheCsv) {
  const EpisodeTable table = invented_table();
  const LabFigure figure = curve_figure("Figure", {small_panel(table)}, 1, "");
  EXPECT_THAT(figure.csv, HasSubstr("\"path\",\"MSE [m2]\",\"l2, top m\",simple,fast_l2_10,10,1,7,,\n"));
  EXPECT_THAT(figure.csv, HasSubstr("\"path\",\"MSE [m2]\",\"l2, top m\",simple,fast_l2_40,40,2,2,"));
  EXPECT_THAT(figure.csv, Not(HasSubstr("Hadamard"))) << "no row has it";
  ASSERT_EQ(figure.sheet.charts.size(), 1u);
  EXPECT_EQ(figure.sheet.charts[0].series.size(), 2u);
  EXPECT_EQ(seeds_text({small_panel(table)}), "1 to 2 seeds");
}

TEST(Curve, PutsNoErrorOntoALogarithmicAxisButNotIntoTheCsv) {
  const EpisodeTable table = invented_table();
  const LabFigure figure = curve_figure("Figure", {small_panel(table)}, 1, "");
  EXPECT_THAT(figure.sheet.charts[0].series[1].y, ElementsAre(1e-9));
  EXPECT_THAT(figure.csv, HasSubstr("nesta_40,40,1,0,,\n"));
}

TEST(Pareto, KeepsWhatNothingElseBeats) {
  const auto front = pareto_front({{300, 1}, {100, 5}, {200, 6}, {200, 5}, {250, 2}, {100, 7}, {400, 1}});
  std::vector<double> prices, errors;
  for (const Offer& offer : front) {
    prices.push_back(offer.price);
    errors.push_back(offer.error);
  }
  EXPECT_THAT(prices, ElementsAre(100, 250, 300));
  EXPECT_THAT(errors, ElementsAre(5, 2, 1));
  EXPECT_TRUE(pareto_front({}).empty());
}

std::vector<CurvePoint> points_of(const std::vector<double>& x, const std::vector<double>& mean) {
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({"", "", x[i], {.count = 1, .mean = mean[i]}});
  return points;
}

TEST(Thresholds, BudgetBuysTheDearestThatItPaysFor) {
  const auto within = within_budgets(points_of({10, 20, 40}, {9, 8, 7}), {5, 10, 39, 1000});
  ASSERT_EQ(within.size(), 3u) << "5 pays for nothing";
  EXPECT_EQ(within[0].x, 10);
  EXPECT_EQ(within[0].y.mean, 9);
  EXPECT_EQ(within[1].x, 39);
  EXPECT_EQ(within[1].y.mean, 8);
  EXPECT_EQ(within[2].y.mean, 7);
}

TEST(Thresholds, EnoughIsWhereTheErrorStaysSmall) {
  EXPECT_EQ(least_within(points_of({5, 10, 20, 40}, {1, 0.1, 1, 0.1}), 0.5), 40);
  EXPECT_EQ(least_within(points_of({5, 10, 20, 40}, {1, 0.1, 0.5, 0}), 0.5), 10);
  EXPECT_EQ(least_within(points_of({5, 10}, {0, 1}), 0.5), std::nullopt);
  EXPECT_EQ(least_within({}, 0.5), std::nullopt);
}

TEST(Picture, ShowsProbabilitiesSaturatedAsTheyAreScored) {
  Grid<float> map({.cell_size = 0.5, .lattice_min = {2, -1}, .width = 2, .height = 1});
  map[{0, 0}] = 0.0F;
  map[{1, 0}] = 100.0F;  // saturated
  const Chart chart = map_chart("map", "below", map);
  ASSERT_TRUE(chart.image);
  EXPECT_FLOAT_EQ(chart.image->values[(Cell{0, 0})], 0.5F);
  EXPECT_NEAR(chart.image->values[(Cell{1, 0})], 0.9608, 1e-4);
  EXPECT_THAT(map_csv("m", map), HasSubstr("map,m,,0,0,1.25,-0.25,0.5\n"));
}

TEST(Picture, KeepsTheShapeOfARoom) {
  World room;
  room.walls.push_back({{-1, -2}, {1, -2}, {1, 2}, {-1, 2}});
  const Chart chart = path_chart("paths", room, {{"truth", {{0, 0, 0}, {0.5, 1, 0}}}});
  EXPECT_NEAR((*chart.x.max - *chart.x.min) / (*chart.y.max - *chart.y.min), 636.0 / 350.0, 0.01);
  EXPECT_LT(*chart.y.min, -2.0);
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_EQ(chart.series[1].name, "truth");
  EXPECT_THAT(chart.series[1].x, ElementsAre(0.0, 0.5));
}

TEST(ExperimentFigures, AreThePapersTwelveToTwentyFourAndOurOwn) {
  std::vector<std::string> names;
  for (const ExperimentFigure& figure : experiment_figures()) {
    EXPECT_FALSE(figure.sweeps.empty()) << figure.name;
    for (const std::string& sweep : figure.sweeps) {
      const std::string file = std::string(COGSLAM_SOURCE_DIR) + "/scenarios/sweeps/" + sweep + ".yaml";
      EXPECT_TRUE(std::filesystem::exists(file)) << file;
    }
    names.push_back(figure.name);
  }
  for (int number = 12; number <= 24; ++number)
    EXPECT_EQ(names.at(static_cast<std::size_t>(number) - 12), std::to_string(number));
  EXPECT_EQ(experiment_figure("forty").name, "forty");
  try {
    experiment_figure("25");
    FAIL() << "expected an error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("no figure '25', expected one of 12, 13, "));
  }
}

}  // namespace
}  // namespace cogslam
