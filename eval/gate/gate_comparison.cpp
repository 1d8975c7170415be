#include "eval/gate/gate_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/check.hpp"
#include "eval/student_t.hpp"

namespace cogslam {
namespace {

struct LogMoments {
  double count = 0.0;
  double mean = 0.0;
  double variance = 0.0;  ///< with n - 1
};

std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> logs;
  for (const double v : values) {
    EXPECTS(v > 0.0 && std::isfinite(v));
    logs.push_back(std::log(v));
  }
  return logs;
}

LogMoments moments_of(std::span<const double> logs) {
  EXPECTS(logs.size() >= 2);
  LogMoments m{.count = static_cast<double>(logs.size())};
  // About the first value: equal values must give their own mean and a spread of exactly nothing.
  for (const double v : logs) m.mean += (v - logs[0]) / m.count;
  m.mean += logs[0];
  if (std::all_of(logs.begin(), logs.end(), [&](double v) { return v == logs[0]; })) return {m.count, logs[0], 0.0};
  for (const double v : logs) m.variance += (v - m.mean) * (v - m.mean) / (m.count - 1.0);
  return m;
}

/// What a mean difference of logarithms is known with.
struct Precision {
  double error = 0.0;  ///< standard error
  double freedom = 1.0;
};

/// With `count` new values of this variance.
Precision unpaired_precision(const LogMoments& b, double count, double variance) {
  const double freedom = b.count + count - 2.0;
  const double pooled = ((b.count - 1.0) * b.variance + (count - 1.0) * variance) / freedom;
  return {std::sqrt(std::max(pooled / b.count + pooled / count, b.variance / b.count + variance / count)), freedom};
}

double resolution(const Precision& precision, const ChangeLimits& limits) {
  const double t = student_t_exceeded_with(limits.false_alarm, precision.freedom) +
                   student_t_exceeded_with(1.0 - limits.power, precision.freedom);
  return (1.0 + limits.tolerance) * std::exp(t * precision.error) - 1.0;
}

/// Exact figures have no error: then any change beyond the tolerance is certain.
double tail_of(double excess, const Precision& precision) {
  if (precision.error > 0.0) return student_t_tail(excess / precision.error, precision.freedom);
  return excess > 0.0 ? 0.0 : 1.0;
}

Change judge(double log_baseline, double log_now, double log_change, const Precision& precision,
             const ChangeLimits& limits) {
  const double margin = student_t_exceeded_with(limits.false_alarm, precision.freedom) * precision.error;
  Change c{.baseline = std::exp(log_baseline), .now = std::exp(log_now)};
  c.change = std::expm1(log_change);
  c.at_least = std::expm1(log_change - margin);
  c.resolves = resolution(precision, limits);
  c.p_value = tail_of(log_change - std::log1p(limits.tolerance), precision);
  c.better = log_change + margin < 0.0;
  if (c.p_value < limits.false_alarm) {
    c.verdict = Verdict::kFail;
  } else {
    c.verdict = c.resolves <= limits.effect ? Verdict::kPass : Verdict::kNotMeasured;
  }
  return c;
}

}  // namespace

Change compare_unpaired(std::span<const double> baseline, std::span<const double> now, const ChangeLimits& limits) {
  const LogMoments b = moments_of(logarithms(baseline)), n = moments_of(logarithms(now));
  return judge(b.mean, n.mean, n.mean - b.mean, unpaired_precision(b, n.count, n.variance), limits);
}

Change compare_paired(std::span<const double> baseline, std::span<const double> now, const ChangeLimits& limits) {
  EXPECTS(baseline.size() == now.size());
  const std::vector<double> b = logarithms(baseline), n = logarithms(now);
  std::vector<double> differences;
  for (std::size_t i = 0; i < b.size(); ++i) differences.push_back(n[i] - b[i]);
  const LogMoments d = moments_of(differences);
  return judge(moments_of(b).mean, moments_of(n).mean, d.mean, {std::sqrt(d.variance / d.count), d.count - 1.0},
               limits);
}

FigureSpread spread_of(std::span<const double> values) {
  const LogMoments m = moments_of(logarithms(values));
  return {std::exp(m.mean), std::sqrt(m.variance)};
}

double unpaired_resolution(std::span<const double> baseline, std::size_t seeds, const ChangeLimits& limits) {
  EXPECTS(seeds >= 2);
  const LogMoments b = moments_of(logarithms(baseline));
  return resolution(unpaired_precision(b, static_cast<double>(seeds), b.variance), limits);
}

}  // namespace cogslam
