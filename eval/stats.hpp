#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace cogslam {

/// A mean with its 95 % confidence interval, mean +- half_width.
struct MeanInterval {
  std::size_t count = 0;
  double mean = 0.0;
  double half_width = 0.0;  ///< Student's t times the standard error; 0 for a single value, which tells no spread

  [[nodiscard]] double low() const { return mean - half_width; }
  [[nodiscard]] double high() const { return mean + half_width; }
};

/// Of at least one value; summed in the given order.
MeanInterval mean_interval(std::span<const double> values);

/// An interval that need not be symmetric.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The 95 % percentile bootstrap interval of the mean: of `resamples` samples drawn with replacement (Efron and
/// Tibshirani 1993, 13.3). At least one value; the same values and seed give the same interval. Below about ten values
/// it is too narrow: trust Student's t there.
Interval bootstrap_mean(std::span<const double> values, std::uint32_t seed = 1, std::size_t resamples = 2000);

/// Values measured under the same conditions, one under each of two treatments: common random numbers.
struct PairedComparison {
  MeanInterval difference{};            ///< of value - reference, with Student's t
  Interval bootstrap{};                 ///< of its mean
  std::optional<double> correlation{};  ///< Pearson's; nothing where either does not vary
};

/// Of as many `values` as `references`, at least one pair, in the same order.
PairedComparison compare_pairs(std::span<const double> values, std::span<const double> references);

/// The middle value (the mean of the two in the middle for an even count), of at least one value.
double median(std::span<const double> values);

/// The t beyond which a Student's t variable of `freedom` >= 1 degrees lies with probability 0.025 on each side.
double student_t_975(std::size_t freedom);

}  // namespace cogslam
