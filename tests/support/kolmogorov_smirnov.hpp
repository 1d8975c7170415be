#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace cogslam {

/// Kolmogorov-Smirnov: the largest gap between the values' distribution and `cdf`, times the root of their number.
/// For draws from `cdf` it exceeds 1.63 once in a hundred samples and 1.95 once in a thousand.
template <class Cdf>
double ks_statistic(std::vector<double> values, Cdf&& cdf) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double gap = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = cdf(values[i]);
    gap = std::max({gap, expected - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - expected});
  }
  return gap * std::sqrt(n);
}

}  // namespace cogslam
