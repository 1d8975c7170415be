#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/grid.hpp"
#include "worlds/truth_grid.hpp"

// Every map is scored on log-odds saturated to the same bounds: else the score measures how far a store lets a cell
// go, not what the cell says. Estimates may cover more or less than the truth, on the same lattice: what lies outside
// the truth is not scored, what lies outside the estimate is unknown (log-odds 0).

namespace cogslam {

constexpr double kScoredLogOddsMin = -2.0;  ///< p = 0.119
constexpr double kScoredLogOddsMax = 3.2;   ///< p = 0.961

/// What a cell's belief says: free below p = 0.35, occupied above p = 0.65, else unknown.
enum class CellClass : std::uint8_t { kFree = 0, kUnknown = 1, kOccupied = 2 };
CellClass classify(double log_odds);

/// Probability of being occupied, of log-odds saturated to the bounds above. NaN breaks the contract.
double scored_probability(double log_odds);

/// An estimated map against the truth of its cells.
struct MapError {
  std::size_t observable = 0;  ///< cells whose truth is free (p = 0) or occupied (p = 1)
  std::size_t all = 0;         ///< cells of the truth's frame
  double mse = 0.0;            ///< of probability, over observable cells
  double mse_all = 0.0;        ///< of probability, over all cells; the truth of an unobservable one is 0.5
  /// Of saturated log-odds, over all cells. Truth: the lower bound for free, the upper for occupied, 0 for
  /// unobservable.
  double mse_logodds = 0.0;
  double log_score = 0.0;  ///< mean of -ln(probability given to what is true) over observable cells [nats]
  /// Observable cells by truth (free, occupied) and belief (CellClass).
  std::array<std::array<std::size_t, 3>, 2> confusion{};
};

/// Nothing where no cell of the truth is observable. Both grids must have the same cell size.
std::optional<MapError> map_error(const Grid<TruthCell>& truth, const Grid<float>& log_odds);

/// MSE of probability between two estimates, over all cells of `area` (the truth's frame). Nothing for an empty area.
std::optional<double> map_difference(const GridFrame& area, const Grid<float>& log_odds_a,
                                     const Grid<float>& log_odds_b);

/// The value for a cell of `frame` in a grid on the same lattice: 0 outside it.
double log_odds_at(const Grid<float>& log_odds, const GridFrame& frame, Cell c);

}  // namespace cogslam
