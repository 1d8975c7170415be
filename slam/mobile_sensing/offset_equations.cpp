#include "slam/mobile_sensing/offset_equations.hpp"

#include <algorithm>
#include <cmath>

namespace cogslam {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

template <class Visit>
void for_each_common_cell(const OffsetLevels& levels, const Pose2& T, const Visit& visit) {
  const double c = std::cos(T.theta), s = std::sin(T.theta);
  for (int y = 0; y < levels.second.height(); ++y) {
    for (int x = 0; x < levels.second.width(); ++x) {
      const OffsetLevel::Sample here = levels.second.at_cell({x, y});
      if (here.weight <= 0.0) continue;
      OffsetLevel::Sample there = levels.first.at({T.x + c * x - s * y, T.y + s * x + c * y});
      if (there.weight <= 0.0) continue;
      there.gradient = {c * there.gradient.x() + s * there.gradient.y(),
                        -s * there.gradient.x() + c * there.gradient.y()};
      visit(Vector2d(x, y), here, there);
    }
  }
}

}  // namespace

OffsetOverlap offset_overlap(const OffsetLevels& levels, const Pose2& T_cells) {
  OffsetOverlap sum;
  double squares = 0.0;
  for_each_common_cell(levels, T_cells, [&](const Vector2d& p, const auto& here, const auto& there) {
    const double w = here.weight * there.weight;
    sum.weight += w;
    sum.centre += w * p;
    squares += w * p.squaredNorm();
  });
  if (sum.weight <= 0.0) return sum;
  sum.centre /= sum.weight;
  sum.radius = std::sqrt(std::max(squares / sum.weight - sum.centre.squaredNorm(), 1.0));
  return sum;
}

OffsetEquations offset_equations(const OffsetLevels& levels, const Pose2& T_cells, const OffsetOverlap& overlap,
                                 double outlier) {
  OffsetEquations sum;
  for_each_common_cell(levels, T_cells, [&](const Vector2d& p, const auto& here, const auto& there) {
    const double r = there.value - here.value;
    const double w = here.weight * there.weight / (1.0 + r * r / (outlier * outlier));
    const Vector2d g = 0.5 * (here.gradient + there.gradient);
    const Vector2d arm = (p - overlap.centre) / overlap.radius;
    const Vector3d row(g.x(), g.y(), arm.x() * g.y() - arm.y() * g.x());
    sum.gradients += w * row * row.transpose();
    sum.right += (w * r) * row;
    sum.squares += w * r * r;
    sum.weight += w;
  });
  return sum;
}

}  // namespace cogslam
