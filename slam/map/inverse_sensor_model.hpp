#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.hpp"
#include "slam/map/cell_window.hpp"
#include "slam/map/lattice.hpp"
#include "slam/map/log_odds.hpp"
#include "slam/sweep.hpp"

namespace cogslam {

/// Writes a sweep seen from a pose into a plain log-odds grid: Alg. 2 (and alpha - beta of Alg. 4, eq. 18).
///
/// Keeps scratch memory between calls, so make one per thread.
class MapUpdater {
 public:
  /// Changes `log_odds` in place, each cell at most once; cells outside its frame are left out.
  /// Returns the lattice window that holds every changed cell.
  CellWindow integrate(const std::vector<Beam>& sweep, const Pose2& T_map_base, const LogOddsModel& model,
                       Grid<float>& log_odds);
  /// The same on levels.
  CellWindow integrate(const std::vector<Beam>& sweep, const Pose2& T_map_base, const LatticeModel& model,
                       Grid<std::int8_t>& levels);

 private:
  template <class Model, class Value>
  CellWindow change(const std::vector<Beam>& sweep, const Pose2& T_map_base, const Model& model, Grid<Value>& cells);
  void mark(const std::vector<Beam>& sweep, const Pose2& T_map_base, CellRule rule, const GridFrame& frame);
  void touch(Cell lattice_cell, const GridFrame& frame, bool hit, bool overwrite);

  std::vector<std::uint32_t> marks_;    ///< per cell: 2 * round + hit, where `round` is the call that wrote it
  std::vector<std::uint32_t> touched_;  ///< indices of the cells marked in this round
  std::uint32_t round_ = 0;
};

/// The lattice cells that a sweep from this pose can touch. Throws InputError beyond kFarthestCell.
CellWindow window_of(const std::vector<Beam>& sweep, const Pose2& T_map_base, double cell_size);

}  // namespace cogslam
