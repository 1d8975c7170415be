#pragma once

#include <algorithm>
#include <cmath>

namespace cogslam {

/// Log-odds of a probability and back: eqs. (11) and (12) of Cain & Leonessa 2016.
inline double log_odds(double probability) { return std::log(probability / (1.0 - probability)); }
inline double probability(double log_odds) { return 1.0 - 1.0 / (1.0 + std::exp(log_odds)); }

/// How several beams of one scan that meet in a cell are joined.
enum class CellRule {
  kHitBeatsMiss,  ///< one change per cell and scan; a hit wins over beams that pass
  kLastBeam,      ///< one change per cell and scan; the last beam wins (Alg. 4 as printed)
};

/// The inverse sensor model: what one scan adds to the log-odds of a cell. The prior l_0 is 0 (p = 0.5).
struct LogOddsModel {
  float hit = 0.8F;     ///< added where a beam ends on a surface
  float free = -0.4F;   ///< added where a beam passes
  bool clamped = true;  ///< keep within [min, max]; false: unbounded, as the paper writes it
  float min = -2.0F;
  float max = 3.2F;
  CellRule rule = CellRule::kHitBeatsMiss;

  [[nodiscard]] float after(float before, float change) const {
    const float sum = before + change;
    return clamped ? std::clamp(sum, min, max) : sum;
  }
};

/// Log-odds above which a cell counts as an obstacle when a pose is matched or weighed.
inline constexpr float kOccupiedLogOdds = 0.5F;
/// Log-odds this near 0 say nothing: a lossy store brings unknown cells back as almost, not quite, 0.
inline constexpr float kUnknownLogOdds = 0.1F;
inline bool is_unknown(float log_odds) { return std::abs(log_odds) < kUnknownLogOdds; }

}  // namespace cogslam
