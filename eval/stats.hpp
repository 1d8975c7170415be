#pragma once

#include <cstddef>
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

/// The middle value (the mean of the two in the middle for an even count), of at least one value.
double median(std::span<const double> values);

/// The t beyond which a Student's t variable of `freedom` >= 1 degrees lies with probability 0.025 on each side.
double student_t_975(std::size_t freedom);

}  // namespace cogslam
