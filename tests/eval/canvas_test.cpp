#include "eval/report/canvas.hpp"

#include <gtest/gtest.h>

#include "core/check.hpp"
#include "core/rng.hpp"
#include "eval/report/palette.hpp"
#include "eval/report/scale_bar.hpp"

namespace cogslam {
namespace {

/// How much black there is on white paper, in pixels.
double ink(const Canvas& canvas) {
  double sum = 0.0;
  for (const std::uint8_t v : canvas.rgb()) sum += 1.0 - v / 255.0;
  return sum / 3.0;
}

TEST(Canvas, DrawsLinesOfTheRightAreaAtAnyAngle) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng({.seed = seed});
    Canvas canvas(200, 200, kWhite);
    const Eigen::Vector2d ends[] = {{rng.uniform(20, 180), rng.uniform(20, 180)},
                                    {rng.uniform(20, 180), rng.uniform(20, 180)}};
    canvas.draw_line(ends, 4.0, kBlack);
    const double expected = 4.0 * (ends[1] - ends[0]).norm() + 3.14159 * 4.0;  // and two round ends
    EXPECT_NEAR(ink(canvas), expected, 0.03 * expected + 1.0) << "seed " << seed;
  }
}

TEST(Canvas, PaintsJointsOnce) {
  Canvas straight(60, 20, kWhite), jointed(60, 20, kWhite);
  const Eigen::Vector2d two[] = {{10, 10.3}, {50, 10.3}};
  const Eigen::Vector2d many[] = {{10, 10.3}, {11, 10.3}, {20, 10.3}, {20, 10.3}, {35, 10.3}, {50, 10.3}};
  straight.draw_line(two, 3.0, kBlack);
  jointed.draw_line(many, 3.0, kBlack);
  EXPECT_EQ(straight.rgb(), jointed.rgb());
}

TEST(Canvas, FillsPolygonsByTheEvenOddRule) {
  Canvas canvas(10, 10, kWhite);
  const Eigen::Vector2d square[] = {{2, 3}, {7, 3}, {7, 8}, {2, 8}};
  canvas.fill_polygon(square, kBlack);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      EXPECT_EQ(canvas.pixel(x, y), (x >= 2 && x < 7 && y >= 3 && y < 8) ? kBlack : kWhite) << x << ' ' << y;
    }
  }
}

TEST(Canvas, LeavesOutWhatFallsOutside) {
  Canvas canvas(10, 10, kWhite);
  const Eigen::Vector2d line[] = {{-1e12, 5}, {1e12, 5}};
  canvas.draw_line(line, 2.0, kBlack);
  EXPECT_NEAR(ink(canvas), 20.0, 0.5);
  const Eigen::Vector2d far[] = {{-90, -90}, {-50, -70}};
  Canvas empty(10, 10, kWhite);
  empty.draw_line(far, 2.0, kBlack);
  empty.fill_polygon(far, kBlack);
  empty.fill_rectangle(-5, -5, 3, 3, kBlack);
  empty.draw_text(50, 50, "far", 2, kBlack);
  EXPECT_EQ(ink(empty), 0.0);
}

TEST(Canvas, DrawsTextAsWideAsItSays) {
  Canvas canvas(100, 30, kWhite);
  canvas.draw_text(4, 3, "H\xC3", 2, kBlack);
  int last = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 100; ++x) {
      if (canvas.pixel(x, y) == kBlack) last = std::max(last, x);
    }
  }
  EXPECT_EQ(last, 4 + Canvas::text_width("H\xC3", 2) - 1);
  EXPECT_EQ(canvas.pixel(4, 3), kBlack);  // upper left dot of the H
}

/// Black pixels from the left end of a scale bar at (5, 5), along its middle.
int bar_length(double pixels_per_metre) {
  Canvas canvas(600, 40, kWhite);
  draw_scale_bar(canvas, 5, 5, pixels_per_metre);
  int length = 0;
  while (canvas.pixel(5 + length, 5 + 8) == kBlack) ++length;
  return length;
}

TEST(ScaleBar, IsAMetreOrTheNextPowerOfTenThatCanBeSeen) {
  EXPECT_EQ(bar_length(190.4), 190);
  EXPECT_EQ(bar_length(24.0), 24);
  EXPECT_EQ(bar_length(23.0), 230);
  EXPECT_EQ(bar_length(0.5), 50);
}

TEST(Canvas, RejectsImpossibleSizes) {
  EXPECT_THROW(Canvas(0, 10, kWhite), ContractViolation);
  EXPECT_THROW(Canvas(10, 1 << 20, kWhite), ContractViolation);
}

}  // namespace
}  // namespace cogslam
