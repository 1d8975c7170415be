#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "slam/codec/coefficient_code.hpp"

namespace cogslam::slow {

/// Alg. 7 as printed, with the sort made stable: all indices in descending order of magnitude, of which the first m
/// stay.
inline CoefficientCode sort_and_keep(std::span<const float> coefficients, std::size_t m) {
  std::vector<std::uint32_t> order(coefficients.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::abs(coefficients[a]) > std::abs(coefficients[b]);
  });
  order.resize(std::min(m, order.size()));
  std::erase_if(order, [&](std::uint32_t i) { return coefficients[i] == 0.0F; });
  std::sort(order.begin(), order.end());
  CoefficientCode code{order, {}};
  for (const std::uint32_t i : order) {
    code.values.push_back(coefficients[i]);
  }
  return code;
}

}  // namespace cogslam::slow
