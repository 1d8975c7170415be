#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cogslam {

/// Three things that must not be mixed up: a gate that cannot see has not let anything pass.
enum class Verdict : std::uint8_t {
  kPass,         ///< not proved worse than tolerated, and a change of the stated effect would have been found
  kFail,         ///< proved worse than tolerated
  kNotMeasured,  ///< neither: no figures, or too few seeds to find the stated effect
};

/// What one figure is held to. All changes are ratios less one: 0.05 is 5 % more.
struct ChangeLimits {
  double tolerance = 0.0;     ///< a true change up to this is accepted, however certain it is
  double effect = 0.25;       ///< a true change of this size must be found with probability `power`
  double false_alarm = 0.01;  ///< probability of failing where the true change is the tolerance; less below it
  double power = 0.8;
};

/// How a figure has changed, as a ratio of geometric means over seeds, and how well that is known.
struct Change {
  Verdict verdict = Verdict::kNotMeasured;
  double baseline = 0.0;  ///< geometric mean over seeds
  double now = 0.0;       ///< geometric mean over seeds
  double change = 0.0;    ///< now / baseline - 1
  double at_least = 0.0;  ///< lower end of the one-sided interval of confidence 1 - false_alarm
  double resolves = 0.0;  ///< smallest true change that is found with probability `power`
  double p_value = 1.0;   ///< of a change at least as bad where the true one is the tolerance
  bool better = false;    ///< proved to be less than the baseline, at the same confidence
};

/// One-sided test of "more than (1 + tolerance) times as much" on the logarithms of figures, one for each seed.
/// Errors and bytes of unchanged code scatter by factors: their logarithms are near normal (docs/gate.md).
///
/// `compare_unpaired`: other seeds than the baseline's; Student's t of nb + n - 2 degrees with the larger of the pooled
/// and the unpooled (Welch) standard error, so that neither a wider nor a narrower spread makes the test bold.
/// `compare_paired`: figures in the order of the same seeds; Student's t of the differences, n - 1 degrees.
/// All values positive and finite, at least two of each; EXPECTS so.
Change compare_unpaired(std::span<const double> baseline, std::span<const double> now, const ChangeLimits& limits);
Change compare_paired(std::span<const double> baseline, std::span<const double> now, const ChangeLimits& limits);

/// A figure over seeds.
struct FigureSpread {
  double mean = 0.0;    ///< geometric
  double spread = 0.0;  ///< standard deviation of the logarithm: 0.1 is about 10 %
};
FigureSpread spread_of(std::span<const double> values);

/// What `compare_unpaired` will resolve with `seeds` new figures that scatter like the baseline's.
double unpaired_resolution(std::span<const double> baseline, std::size_t seeds, const ChangeLimits& limits);

}  // namespace cogslam
