#pragma once

#include <vector>

#include "core/grid.hpp"
#include "slam/map/log_odds.hpp"
#include "slam/sweep.hpp"
#include "tests/support/touched_cells.hpp"

namespace cogslam::slow {

/// What a sweep says of a cell. kUnclear: a beam passes or ends within rounding of the cell's border.
enum class Verdict { kUntouched, kFree, kHit, kUnclear };

/// What one beam says of one cell; points in cells.
inline Verdict verdict_of_beam(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool hit, Cell c) {
  constexpr double kRounding = 1e-9;  // cells
  if (length_inside(from, to, c, kRounding) < 0.0) return Verdict::kUntouched;
  const bool ends_inside = length_inside(to, to, c, -kRounding) >= 0.0;
  const bool ends_near = length_inside(to, to, c, kRounding) >= 0.0;
  if (hit && ends_inside) return Verdict::kHit;
  if (hit && ends_near) return Verdict::kUnclear;
  return length_inside(from, to, c, -kRounding) >= 0.0 ? Verdict::kFree : Verdict::kUnclear;
}

/// Alg. 4 word for word: for every beam l, for every cell, alpha(i) takes what z(l) says of it, so the last beam wins.
/// kHitBeatsMiss: a hit stays, whatever comes later.
inline Grid<Verdict> alpha_of_sweep(const std::vector<Beam>& sweep, const Pose2& T_map_base, CellRule rule,
                                    const GridFrame& frame) {
  Grid<Verdict> alpha(frame, Verdict::kUntouched);
  const Eigen::Vector2d shift(frame.lattice_min.x, frame.lattice_min.y);
  for (const Beam& beam : sweep) {
    const Eigen::Vector2d from = T_map_base * beam.origin / frame.cell_size - shift;
    const Eigen::Vector2d to = T_map_base * beam.end / frame.cell_size - shift;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const Verdict now = verdict_of_beam(from, to, beam.hit, {x, y});
        Verdict& held = alpha[{x, y}];
        if (now == Verdict::kUntouched) continue;
        if (rule == CellRule::kHitBeatsMiss) {
          if (held == Verdict::kHit) continue;
          if (held == Verdict::kUnclear && now == Verdict::kFree) continue;
        }
        held = now;
      }
    }
  }
  return alpha;
}

}  // namespace cogslam::slow
