#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "slam/map/log_odds.hpp"

namespace cogslam {

/// Log-odds as small integers: a level times `unit`. With the usual model (hit +0.8, free -0.4, within [-2, 3.2]) and
/// a unit of 0.4 a cell has 14 levels, -5 to 8, which fit four bits; a finer unit takes one byte.
struct LatticeModel {
  double unit = 0.4;  ///< log-odds of one level
  std::int8_t hit = 2;
  std::int8_t free = -1;
  std::int8_t min = -5;
  std::int8_t max = 8;
  CellRule rule = CellRule::kHitBeatsMiss;

  [[nodiscard]] std::int8_t after(std::int8_t before, int change) const {
    return static_cast<std::int8_t>(std::clamp<int>(before + change, min, max));
  }
};

/// What keeps a model from standing on a lattice: the key, and what is wrong with its value.
struct LatticeTrouble {
  std::string key;
  std::string message;
};

/// Nothing where hit, free, min and max are whole levels within [-128, 127] and the model is clamped.
std::optional<LatticeTrouble> lattice_trouble(const LogOddsModel& model, double unit);

/// The model in levels. It has no trouble.
LatticeModel lattice_model(const LogOddsModel& model, double unit);

/// The level nearest to a log-odds, at most 127 from 0.
std::int8_t level_of(float log_odds, double unit);

/// The log-odds of a level.
inline float log_odds_of(std::int8_t level, double unit) { return static_cast<float>(level * unit); }

}  // namespace cogslam
