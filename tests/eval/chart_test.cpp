#include "eval/report/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "eval/report/chart_scale.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;
using testing::Not;

ChartSheet sheet_of(Series series, bool log = false) {
  Chart chart;
  chart.title = "a < b";
  chart.x.label = "x";
  chart.y.label = "y";
  chart.y.log = log;
  chart.series.push_back(std::move(series));
  return {.heading = "heading", .charts = {chart}};
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(ChartScale, PutsRoundTicksAroundTheData) {
  const ChartScale scale({}, {0.3, 9.2});
  EXPECT_EQ(scale.min(), 0.0);
  EXPECT_EQ(scale.max(), 10.0);
  ASSERT_EQ(scale.ticks().size(), 6U);
  EXPECT_EQ(scale.ticks()[1].label, "2");
  EXPECT_NEAR(*scale.position(5.0), 0.5, 1e-12);
}

TEST(ChartScale, SpreadsDecadesEvenlyAndHidesWhatIsNotAboveZero) {
  const ChartScale scale({.log = true}, {0.002, 30.0, 0.0, -1.0});
  EXPECT_NEAR(scale.min(), 1e-3, 1e-15);
  EXPECT_NEAR(scale.max(), 1e2, 1e-9);
  EXPECT_NEAR(*scale.position(1e-1), 0.4, 1e-12);
  EXPECT_FALSE(scale.position(0.0));
  EXPECT_FALSE(scale.position(std::numeric_limits<double>::infinity()));
  EXPECT_EQ(scale.ticks().front().label, "1e-3");
}

TEST(Chart, LeavesAGapWhereAValueCannotBeShown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Series whole{.x = {0, 1, 2, 3, 4}, .y = {1, 2, 3, 2, 1}, .style = SeriesStyle::kLineOnly};
  Series broken = whole;
  broken.y[2] = nan;
  EXPECT_EQ(count(chart_svg(sheet_of(whole)), "<polyline"), 1U);
  EXPECT_EQ(count(chart_svg(sheet_of(broken)), "<polyline"), 2U);
  EXPECT_THAT(chart_svg(sheet_of(broken)), Not(HasSubstr("nan")));
}

TEST(Chart, WritesNamesBandsAndMarkers) {
  const Series series{.name = "l2 & CS", .x = {0, 1, 2}, .y = {1, 2, 3}, .low = {0.5, 1.5, 2.5}, .high = {2, 3, 4}};
  const std::string svg = chart_svg(sheet_of(series));
  EXPECT_THAT(svg, HasSubstr("l2 &amp; CS"));
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  EXPECT_EQ(count(svg, "fill-opacity"), 1U);
  EXPECT_EQ(count(svg, "<polygon"), 1U + 3U + 1U);  // band, markers, marker in the legend
  EXPECT_EQ(svg, chart_svg(sheet_of(series)));
}

TEST(Chart, IsTheSamePngEachTimeAndDiffersWithTheData) {
  const Series series{.x = {0, 1, 2}, .y = {1, 2, 3}};
  Series other = series;
  other.y[1] = 2.5;
  const std::string png = chart_png(sheet_of(series));
  EXPECT_THAT(png, testing::StartsWith("\x89PNG"));
  EXPECT_EQ(png, chart_png(sheet_of(series)));
  EXPECT_NE(png, chart_png(sheet_of(other)));
}

}  // namespace
}  // namespace cogslam
