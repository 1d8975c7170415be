#include "slam/map/inverse_sensor_model.hpp"

#include "core/cell_walk.hpp"
#include "core/error.hpp"
#include "slam/map/reach.hpp"

namespace cogslam {
namespace {

/// A point of the base frame in cells of the lattice: one unit is one cell side. Not in cells of a frame: taking its
/// corner off before rounding would put a point on a cell border into different cells for different windows.
class ToCells {
 public:
  ToCells(const Pose2& T_map_base, double cell_size)
      : c_(std::cos(T_map_base.theta) / cell_size),
        s_(std::sin(T_map_base.theta) / cell_size),
        x_(T_map_base.x / cell_size),
        y_(T_map_base.y / cell_size) {}
  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    return {x_ + c_ * p.x() - s_ * p.y(), y_ + s_ * p.x() + c_ * p.y()};
  }

 private:
  double c_, s_, x_, y_;
};

Cell cell_at(const Eigen::Vector2d& p) {
  return {static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
}

}  // namespace

// In line: called for every cell of every beam.
[[gnu::always_inline]] inline void MapUpdater::touch(Cell lattice_cell, const GridFrame& frame, bool hit,
                                                     bool overwrite) {
  const Cell c{lattice_cell.x - frame.lattice_min.x, lattice_cell.y - frame.lattice_min.y};
  if (!frame.contains(c)) return;
  const auto index = static_cast<std::uint32_t>(frame.index(c));
  std::uint32_t& mark = marks_[index];
  if (mark >= 2 * round_) {  // marked in this round: no later round has been
    if (overwrite) mark = 2 * round_ + (hit ? 1U : 0U);
    return;
  }
  mark = 2 * round_ + (hit ? 1U : 0U);
  touched_.push_back(index);
}

void MapUpdater::mark(const std::vector<Beam>& sweep, const Pose2& T_map_base, CellRule rule, const GridFrame& frame) {
  const ToCells to_cells(T_map_base, frame.cell_size);
  const bool last_beam_wins = rule == CellRule::kLastBeam;
  if (!last_beam_wins) {  // all hits first: what passes later cannot undo them
    for (const Beam& beam : sweep) {
      if (beam.hit) touch(cell_at(to_cells(beam.end)), frame, true, false);
    }
  }
  for (const Beam& beam : sweep) {
    const Eigen::Vector2d end = to_cells(beam.end);
    const Cell last = cell_at(end);
    walk_cells(to_cells(beam.origin), end, [&](Cell c) {
      if (!(c == last) || !beam.hit) touch(c, frame, false, last_beam_wins);
      return true;
    });
    if (last_beam_wins && beam.hit) touch(last, frame, true, true);
  }
}

template <class Model, class Value>
CellWindow MapUpdater::change(const std::vector<Beam>& sweep, const Pose2& T_map_base, const Model& model,
                              Grid<Value>& cells) {
  const GridFrame& frame = cells.frame();
  if (marks_.size() < frame.size()) marks_.resize(frame.size(), 0);
  if (++round_ == (1U << 31)) {  // marks of two billion calls ago would look fresh
    std::fill(marks_.begin(), marks_.end(), 0);
    round_ = 1;
  }
  touched_.clear();
  mark(sweep, T_map_base, model.rule, frame);

  CellWindow changed;
  const auto width = static_cast<std::uint32_t>(frame.width);
  for (const std::uint32_t index : touched_) {
    Value& value = cells.values()[index];
    value = model.after(value, (marks_[index] & 1U) != 0 ? model.hit : model.free);
    changed.include(
        {frame.lattice_min.x + static_cast<int>(index % width), frame.lattice_min.y + static_cast<int>(index / width)});
  }
  return changed;
}

CellWindow MapUpdater::integrate(const std::vector<Beam>& sweep, const Pose2& T_map_base, const LogOddsModel& model,
                                 Grid<float>& log_odds) {
  return change(sweep, T_map_base, model, log_odds);
}

CellWindow MapUpdater::integrate(const std::vector<Beam>& sweep, const Pose2& T_map_base, const LatticeModel& model,
                                 Grid<std::int8_t>& levels) {
  return change(sweep, T_map_base, model, levels);
}

CellWindow window_of(const std::vector<Beam>& sweep, const Pose2& T_map_base, double cell_size) {
  const ToCells to_cells(T_map_base, cell_size);
  CellWindow window;
  for (const Beam& beam : sweep) {
    for (const Eigen::Vector2d& p : {to_cells(beam.origin), to_cells(beam.end)}) {
      if (!(p.cwiseAbs().maxCoeff() < kFarthestCell)) {
        throw InputError("a scan lies more than 10^9 cells from the map's origin: look for jumps in the odometry");
      }
      window.include(cell_at(p));
    }
  }
  return window;
}

}  // namespace cogslam
