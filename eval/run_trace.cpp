#include "eval/run_trace.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/check.hpp"
#include "eval/metrics/map_error.hpp"
#include "slam/map/cell_window.hpp"

namespace cogslam {
namespace {

constexpr double kLevels = 20.0;

/// Later changes win.
MapChange joined(const std::vector<MapChange>& changes, std::size_t first, std::size_t last) {
  std::map<std::uint32_t, std::uint8_t> cells;
  for (std::size_t i = first; i <= last; ++i) {
    for (std::size_t c = 0; c < changes[i].cells.size(); ++c) cells[changes[i].cells[c]] = changes[i].levels[c];
  }
  MapChange change{.record = changes[last].record};
  for (const auto& [cell, level] : cells) {
    change.cells.push_back(cell);
    change.levels.push_back(level);
  }
  return change;
}

/// Where a cell of `from` lies in `to`, which holds it.
std::uint32_t moved(std::uint32_t cell, const GridFrame& from, const GridFrame& to) {
  const auto width = static_cast<std::uint32_t>(from.width);
  const Cell at{static_cast<int>(cell % width) + from.lattice_min.x - to.lattice_min.x,
                static_cast<int>(cell / width) + from.lattice_min.y - to.lattice_min.y};
  return static_cast<std::uint32_t>(to.index(at));
}

}  // namespace

std::uint8_t map_level(float log_odds) {
  const double value = std::isnan(log_odds) ? 0.0 : static_cast<double>(log_odds);
  const int level = static_cast<int>(std::lround(kLevels * scored_probability(value)));
  switch (classify(value)) {
    case CellClass::kFree:
      return static_cast<std::uint8_t>(std::clamp(level, 0, 6));
    case CellClass::kUnknown:
      break;
    case CellClass::kOccupied:
      return static_cast<std::uint8_t>(std::clamp(level, 14, 20));
  }
  return static_cast<std::uint8_t>(std::clamp(level, 7, 13));
}

Grid<std::uint8_t> map_levels(const Grid<float>& log_odds) {
  Grid<std::uint8_t> levels(log_odds.frame());
  for (std::size_t i = 0; i < levels.values().size(); ++i) levels.values()[i] = map_level(log_odds.values()[i]);
  return levels;
}

void MapTrace::cover(const GridFrame& frame) {
  const CellWindow now = window_of(shown_.frame()), more = window_of(frame);
  if (more.empty() || (!now.empty() && now.contains(more))) return;
  CellWindow both = more;
  if (!now.empty()) {
    both.include(now.min);
    both.include(now.max);
  }
  const GridFrame old = shown_.frame();
  Grid<std::uint8_t> grown(both.frame(frame.cell_size), kUnknownLevel);
  for (std::uint32_t c = 0; c < old.size(); ++c) grown.values()[moved(c, old, grown.frame())] = shown_.values()[c];
  for (MapChange& change : changes_) {
    for (std::uint32_t& cell : change.cells) cell = moved(cell, old, grown.frame());
  }
  shown_ = std::move(grown);
}

void MapTrace::add(std::size_t record, const Grid<std::uint8_t>& levels) {
  EXPECTS(changes_.empty() || changes_.back().record <= record);
  cover(levels.frame());
  const GridFrame &all = shown_.frame(), &part = levels.frame();
  MapChange change{.record = record};
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const Cell c{static_cast<int>(i % static_cast<std::uint32_t>(all.width)) + all.lattice_min.x - part.lattice_min.x,
                 static_cast<int>(i / static_cast<std::uint32_t>(all.width)) + all.lattice_min.y - part.lattice_min.y};
    const std::uint8_t level = part.contains(c) ? levels[c] : kUnknownLevel;
    if (level == shown_.values()[i]) continue;
    shown_.values()[i] = level;
    change.cells.push_back(i);
    change.levels.push_back(level);
  }
  changes_.push_back(std::move(change));
}

void MapTrace::thin(std::size_t step) {
  EXPECTS(step > 0);
  std::vector<MapChange> kept;
  std::size_t first = 0;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    if (i % step != 0 && i + 1 != changes_.size()) continue;
    kept.push_back(joined(changes_, first, i));
    first = i + 1;
  }
  changes_ = std::move(kept);
}

std::vector<std::size_t> frame_records(const Recording& recording, std::size_t most) {
  EXPECTS(most > 0);
  std::vector<std::size_t> scans, frames;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    if (recording.readings[i].scan) scans.push_back(i);
  }
  const std::size_t step = std::max<std::size_t>(1, (scans.size() + most - 1) / most);
  for (std::size_t i = 0; i < scans.size(); i += step) frames.push_back(scans[i]);
  if (!scans.empty() && frames.back() != scans.back()) frames.push_back(scans.back());
  return frames;
}

TraceRecorder::TraceRecorder(const Recording& recording, const TraceLimits& limits)
    : limits_(limits), frames_(frame_records(recording, limits.frames)) {
  EXPECTS(limits.particles > 0 && limits.maps > 0);
  frames_per_map_ = std::max<std::size_t>(1, (frames_.size() + limits.maps - 1) / limits.maps);
}

void TraceRecorder::note(std::size_t record, bool registered, const LastScan& scan) {
  if (!registered) return;
  trace_.registered.push_back({record, scan});
  cloud_changed_ = map_changed_ = true;
}

bool TraceRecorder::due(std::size_t record) const {
  return next_frame_ < frames_.size() && frames_[next_frame_] == record;
}

void TraceRecorder::look(std::size_t record, const Belief& belief) {
  if (!due(record)) return;
  if (cloud_changed_ && belief.cloud) trace_.clouds.push_back({record, some_of(belief.cloud())});
  cloud_changed_ = false;
  if (map_changed_ && next_frame_ % frames_per_map_ == 0) {
    trace_.map.add(record, map_levels(belief.map()));
    map_changed_ = false;
  }
  ++next_frame_;
}

RunTrace TraceRecorder::finish(const Grid<float>& map) {
  if (!frames_.empty()) trace_.map.add(frames_.back(), map_levels(map));
  return std::move(trace_);
}

std::vector<Pose2> TraceRecorder::some_of(const std::vector<Pose2>& cloud) const {
  const std::size_t n = std::min(cloud.size(), limits_.particles);
  std::vector<Pose2> some;
  for (std::size_t i = 0; i < n; ++i) some.push_back(cloud[i * cloud.size() / n]);
  return some;
}

}  // namespace cogslam
