#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/report/chart.hpp"

namespace cogslam {

struct Tick {
  double value = 0.0;
  std::string label;  ///< empty for a minor one
};

/// From values of an axis to positions along it.
class ChartScale {
 public:
  /// Covers `axis.min` to `axis.max`; where one is not given, the least and greatest of `values` that can be shown,
  /// widened to a round number (to a power of ten on a logarithmic axis).
  ChartScale(const ChartAxis& axis, const std::vector<double>& values);

  /// 0 at the lower end, 1 at the upper; beyond them outside [0, 1]. Nothing where `value` cannot be shown.
  [[nodiscard]] std::optional<double> position(double value) const;
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double max() const { return max_; }
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void make_linear(const ChartAxis& axis, const std::vector<double>& shown);
  void make_log(const ChartAxis& axis, const std::vector<double>& shown);

  bool log_;
  double min_ = 0.0;
  double max_ = 1.0;
  std::vector<Tick> ticks_;
};

}  // namespace cogslam
