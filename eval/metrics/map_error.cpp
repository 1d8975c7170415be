#include "eval/metrics/map_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

double squared(double v) { return v * v; }

double saturated(double log_odds) {
  EXPECTS(!std::isnan(log_odds));
  return std::clamp(log_odds, kScoredLogOddsMin, kScoredLogOddsMax);
}

double probability(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

/// What a perfect map says in a cell.
struct Target {
  double probability;
  double log_odds;
};

Target target(TruthCell cell) {
  switch (cell) {
    case TruthCell::kFree:
      return {0.0, kScoredLogOddsMin};
    case TruthCell::kOccupied:
      return {1.0, kScoredLogOddsMax};
    case TruthCell::kUnobservable:
      break;
  }
  return {0.5, 0.0};
}

}  // namespace

CellClass classify(double log_odds) {
  const double p = probability(log_odds);
  return p < 0.35 ? CellClass::kFree : p > 0.65 ? CellClass::kOccupied : CellClass::kUnknown;
}

double scored_probability(double log_odds) { return probability(saturated(log_odds)); }

double log_odds_at(const Grid<float>& log_odds, const GridFrame& frame, Cell c) {
  EXPECTS(log_odds.frame().cell_size == frame.cell_size);
  const Cell shift{frame.lattice_min.x - log_odds.frame().lattice_min.x,
                   frame.lattice_min.y - log_odds.frame().lattice_min.y};
  const Cell there{c.x + shift.x, c.y + shift.y};
  return log_odds.frame().contains(there) ? static_cast<double>(log_odds[there]) : 0.0;
}

std::optional<MapError> map_error(const Grid<TruthCell>& truth, const Grid<float>& log_odds) {
  const GridFrame& frame = truth.frame();
  MapError sum{.all = frame.size()};
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const TruthCell cell = truth[{x, y}];
      const double l = saturated(log_odds_at(log_odds, frame, {x, y})), p = probability(l);
      const Target goal = target(cell);
      sum.mse_all += squared(p - goal.probability);
      sum.mse_logodds += squared(l - goal.log_odds);
      if (cell == TruthCell::kUnobservable) continue;
      const bool occupied = cell == TruthCell::kOccupied;
      ++sum.observable;
      sum.mse += squared(p - goal.probability);
      sum.log_score -= std::log(occupied ? p : 1.0 - p);
      ++sum.confusion[occupied ? 1 : 0][static_cast<std::size_t>(classify(l))];
    }
  }
  if (sum.observable == 0) return std::nullopt;
  const auto observable = static_cast<double>(sum.observable), all = static_cast<double>(sum.all);
  sum.mse /= observable;
  sum.log_score /= observable;
  sum.mse_all /= all;
  sum.mse_logodds /= all;
  return sum;
}

std::optional<double> map_difference(const GridFrame& area, const Grid<float>& log_odds_a,
                                     const Grid<float>& log_odds_b) {
  if (area.size() == 0) return std::nullopt;
  double sum = 0.0;
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const Cell c{x, y};
      sum += squared(scored_probability(log_odds_at(log_odds_a, area, c)) -
                     scored_probability(log_odds_at(log_odds_b, area, c)));
    }
  }
  return sum / static_cast<double>(area.size());
}

}  // namespace cogslam
