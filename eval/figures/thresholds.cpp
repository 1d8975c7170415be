#include "eval/figures/thresholds.hpp"

namespace cogslam {

std::vector<CurvePoint> within_budgets(const std::vector<CurvePoint>& points, const std::vector<double>& budgets) {
  std::vector<CurvePoint> within;
  for (const double budget : budgets) {
    const CurvePoint* dearest = nullptr;
    for (const CurvePoint& point : points) {
      if (point.x <= budget) dearest = &point;
    }
    if (dearest == nullptr) continue;
    within.push_back(*dearest);
    within.back().x = budget;
  }
  return within;
}

std::optional<double> least_within(const std::vector<CurvePoint>& points, double bound) {
  std::optional<double> least;
  for (const CurvePoint& point : points) {
    if (point.y.mean > bound) {
      least.reset();
    } else if (!least) {
      least = point.x;
    }
  }
  return least;
}

}  // namespace cogslam
