#include "eval/stats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

/// Nothing where either does not vary beyond rounding.
std::optional<double> pearson(std::span<const double> x, std::span<const double> y) {
  const double mean_x = mean_interval(x).mean, mean_y = mean_interval(y).mean;
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - mean_x, dy = y[i] - mean_y;
    xx += dx * dx;
    yy += dy * dy;
    xy += dx * dy;
  }
  constexpr double kRounding = 1e-12;
  const auto n = static_cast<double>(x.size());
  const bool varies =
      std::sqrt(xx / n) > kRounding * std::abs(mean_x) && std::sqrt(yy / n) > kRounding * std::abs(mean_y);
  if (!varies) return std::nullopt;
  return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

}  // namespace

double student_t_975(std::size_t freedom) {
  EXPECTS(freedom >= 1);
  constexpr std::array<double, 10> kSmall{12.706205, 4.302653, 3.182446, 2.776445, 2.570582,
                                          2.446912,  2.364624, 2.306004, 2.262157, 2.228139};
  if (freedom <= kSmall.size()) return kSmall[freedom - 1];
  // Cornish-Fisher series in 1 / freedom (Abramowitz and Stegun 26.7.5): within 2e-5 from 11 degrees on.
  const double z = 1.959963984540054, v = static_cast<double>(freedom), z2 = z * z;
  return z + z * (z2 + 1.0) / (4.0 * v) + z * ((5.0 * z2 + 16.0) * z2 + 3.0) / (96.0 * v * v) +
         z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / (384.0 * v * v * v) +
         z * ((((79.0 * z2 + 776.0) * z2 + 1482.0) * z2 - 1920.0) * z2 - 945.0) / (92160.0 * v * v * v * v);
}

MeanInterval mean_interval(std::span<const double> values) {
  EXPECTS(!values.empty());
  const auto n = static_cast<double>(values.size());
  MeanInterval result{.count = values.size()};
  for (const double v : values) result.mean += v / n;
  if (values.size() == 1) return result;
  double squares = 0.0;
  for (const double v : values) squares += (v - result.mean) * (v - result.mean);
  result.half_width = student_t_975(values.size() - 1) * std::sqrt(squares / (n - 1.0) / n);
  return result;
}

Interval bootstrap_mean(std::span<const double> values, std::uint32_t seed, std::size_t resamples) {
  EXPECTS(!values.empty() && resamples >= 1);
  std::vector<double> means(resamples);
  for (std::size_t r = 0; r < resamples; ++r) {
    Rng rng({.seed = seed, .purpose = Purpose::kBootstrap, .tick = r});
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[rng.below(static_cast<std::uint32_t>(values.size()))];
    means[r] = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  const auto quantile = [&](double p) {
    return means[std::min(resamples - 1, static_cast<std::size_t>(p * static_cast<double>(resamples)))];
  };
  return {quantile(0.025), quantile(0.975)};
}

PairedComparison compare_pairs(std::span<const double> values, std::span<const double> references) {
  EXPECTS(!values.empty() && values.size() == references.size());
  std::vector<double> differences(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) differences[i] = values[i] - references[i];
  return {mean_interval(differences), bootstrap_mean(differences), pearson(values, references)};
}

double median(std::span<const double> values) {
  EXPECTS(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

}  // namespace cogslam
