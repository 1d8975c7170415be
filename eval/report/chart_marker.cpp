#include "eval/report/chart_marker.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/check.hpp"
#include "eval/report/palette.hpp"

namespace cogslam {
namespace {

struct Shape {
  int corners;
  double turn;    // [rad] of the first corner from the x axis, y downwards
  double radius;  // [pixels]
};

constexpr double kPi = std::numbers::pi;
constexpr std::array<Shape, kLooks> kShapes{{{12, 0.0, 4.5},
                                             {4, kPi / 4.0, 5.5},
                                             {3, -kPi / 2.0, 6.0},
                                             {4, 0.0, 6.0},
                                             {3, kPi / 2.0, 6.0},
                                             {5, -kPi / 2.0, 5.5},
                                             {6, 0.0, 5.0}}};
constexpr std::array<Colour, kLooks> kColours{
    {kBlack, kBlue, kVermilion, {0, 158, 115}, {230, 159, 0}, {204, 121, 167}, kSkyBlue}};

}  // namespace

Colour look_colour(int look) {
  EXPECTS(look >= 0 && look < kLooks);
  return kColours[static_cast<std::size_t>(look)];
}

void draw_marker(ChartPen& pen, const Eigen::Vector2d& centre, int look) {
  EXPECTS(look >= 0 && look < kLooks);
  const Shape& shape = kShapes[static_cast<std::size_t>(look)];
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < shape.corners; ++i) {
    const double angle = shape.turn + 2.0 * kPi * i / shape.corners;
    corners.push_back(centre + shape.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  pen.polygon(corners, look_colour(look));
}

}  // namespace cogslam
