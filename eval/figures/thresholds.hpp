#pragma once

#include <vector>

#include "eval/figures/curve.hpp"

namespace cogslam {

/// For each budget the dearest of `points` (their x is the price, ascending) that it pays for, its x then the budget;
/// nothing for budgets below them all.
std::vector<CurvePoint> within_budgets(const std::vector<CurvePoint>& points, const std::vector<double>& budgets);

/// The least x from which on every point's mean is at most `bound`; nothing where the last exceeds it.
std::optional<double> least_within(const std::vector<CurvePoint>& points, double bound);

}  // namespace cogslam
