#include "eval/report/chart_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

/// 1, 2 or 5 times a power of ten, so that about five steps make up `span`.
double round_step(double span) {
  const double rough = span / 5.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * 0.999) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

ChartScale::ChartScale(const ChartAxis& axis, const std::vector<double>& values) : log_(axis.log) {
  std::vector<double> shown;
  for (const double v : values) {
    if (std::isfinite(v) && (!log_ || v > 0.0)) shown.push_back(v);
  }
  if (shown.empty()) shown = {1.0};
  log_ ? make_log(axis, shown) : make_linear(axis, shown);
}

void ChartScale::make_linear(const ChartAxis& axis, const std::vector<double>& shown) {
  const auto [least, most] = std::minmax_element(shown.begin(), shown.end());
  min_ = axis.min.value_or(*least);
  max_ = axis.max.value_or(*most);
  if (!(max_ > min_)) max_ = min_ + 1.0;
  const double step = round_step(max_ - min_);
  if (!axis.min) min_ = step * std::floor(min_ / step + 1e-9);
  if (!axis.max) max_ = step * std::ceil(max_ / step - 1e-9);
  for (double k = std::ceil(min_ / step - 1e-9); k * step <= max_ + 1e-9 * step; k += 1.0) {
    const double value = k * step + 0.0;  // never -0
    ticks_.push_back({value, fmt::format("{:.6g}", value)});
  }
}

void ChartScale::make_log(const ChartAxis& axis, const std::vector<double>& shown) {
  const auto [least, most] = std::minmax_element(shown.begin(), shown.end());
  min_ = axis.min.value_or(std::pow(10.0, std::floor(std::log10(*least) + 1e-9)));
  max_ = axis.max.value_or(std::pow(10.0, std::ceil(std::log10(*most) - 1e-9)));
  EXPECTS(min_ > 0.0);
  if (!(max_ > min_)) max_ = 10.0 * min_;
  const int low = static_cast<int>(std::ceil(std::log10(min_) - 1e-9));
  const int high = static_cast<int>(std::floor(std::log10(max_) + 1e-9));
  const int stride = std::max(1, (high - low + 7) / 8);
  for (int e = low; e <= high; ++e) {
    const bool major = (e - low) % stride == 0;
    ticks_.push_back({std::pow(10.0, e), major ? fmt::format("1e{}", e) : ""});
  }
}

std::optional<double> ChartScale::position(double value) const {
  if (!std::isfinite(value) || (log_ && value <= 0.0)) return std::nullopt;
  if (log_) return std::log(value / min_) / std::log(max_ / min_);
  return (value - min_) / (max_ - min_);
}

}  // namespace cogslam
