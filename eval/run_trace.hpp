#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/grid.hpp"
#include "core/pose2.hpp"
#include "sensors/log/recording.hpp"
#include "slam/filter_statistics.hpp"

// What the run page replays of one variant: looked at while the variant runs, never a part of its result.

namespace cogslam {

/// How much is kept of a run, however long it is.
struct TraceLimits {
  std::size_t frames = 2000;   ///< moments that the player can show
  std::size_t particles = 64;  ///< of a cloud, evenly spread over the slots
  std::size_t maps = 100;      ///< states of the growing map
};

/// The particles after a frame whose scans registered something.
struct CloudTrace {
  std::size_t record = 0;
  std::vector<Pose2> T_map_base;
};

/// A registered scan.
struct RegisteredTrace {
  std::size_t record = 0;
  LastScan scan{};
};

/// A map in steps of probability of 0.05, 0 to 20: up to 6 free, 7-13 unknown, 14 and more occupied, as `classify` says
/// (a cell at the edge of a class goes to the nearest step of its own).
inline constexpr std::uint8_t kUnknownLevel = 10;
std::uint8_t map_level(float log_odds);
Grid<std::uint8_t> map_levels(const Grid<float>& log_odds);

/// What changed in a map since the state before.
struct MapChange {
  std::size_t record = 0;
  std::vector<std::uint32_t> cells;  ///< indices in the frame of the trace, rising
  std::vector<std::uint8_t> levels;  ///< one per cell
};

/// A growing map: it starts unknown everywhere.
class MapTrace {
 public:
  /// The next state. Its frame may differ from those before; the trace covers all of them.
  void add(std::size_t record, const Grid<std::uint8_t>& levels);
  /// Leaves out all but every `step`-th state and the last; what remains shows what it showed.
  void thin(std::size_t step);

  [[nodiscard]] const GridFrame& frame() const { return shown_.frame(); }
  [[nodiscard]] const std::vector<MapChange>& changes() const { return changes_; }
  /// The state after all changes.
  [[nodiscard]] const Grid<std::uint8_t>& last() const { return shown_; }

 private:
  void cover(const GridFrame& frame);

  Grid<std::uint8_t> shown_;
  std::vector<MapChange> changes_;
};

struct RunTrace {
  std::vector<RegisteredTrace> registered;
  std::vector<CloudTrace> clouds;  ///< none of a mapper that is given the true poses
  MapTrace map;
};

/// The records with a scan that the player shows: every k-th and the last, at most `most` + 1; k as small as it can be.
std::vector<std::size_t> frame_records(const Recording& recording, std::size_t most);

/// Makes a trace while a variant runs.
class TraceRecorder {
 public:
  /// What can be asked of a filter; asked for at frames only.
  struct Belief {
    std::function<std::vector<Pose2>()> cloud;  ///< empty: there are no particles
    std::function<Grid<float>()> map;           ///< of the best particle
  };
  TraceRecorder(const Recording& recording, const TraceLimits& limits);

  /// Tells of each reading taken, in order; `registered`: its scan was. Quick.
  void note(std::size_t record, bool registered, const LastScan& scan);
  /// Whether `look` has something to do at this record.
  [[nodiscard]] bool due(std::size_t record) const;
  void look(std::size_t record, const Belief& belief);
  /// The last state of the map is `map`, whatever was seen before.
  RunTrace finish(const Grid<float>& map);

 private:
  [[nodiscard]] std::vector<Pose2> some_of(const std::vector<Pose2>& cloud) const;

  TraceLimits limits_;
  std::vector<std::size_t> frames_;
  std::size_t frames_per_map_ = 1;
  std::size_t next_frame_ = 0;
  bool cloud_changed_ = false, map_changed_ = false;
  RunTrace trace_;
};

}  // namespace cogslam
