#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "slam/mobile_sensing/offset.hpp"
#include "slam/mobile_sensing/partial_map.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Where the partial maps of a random pair come from.
enum class OffsetSource {
  kDrawn,    ///< the world itself: how much of a cell lies within half a wall's thickness of a surface
  kScanned,  ///< one sweep of an LMS200 each, by the laser measurement model
};

struct OffsetStudy {
  OffsetSource source = OffsetSource::kDrawn;
  PartialMapConfig map{};
  OffsetConfig offset{};
  int samples = 0;  ///< cells of each map that are measured, the others recovered; 0: all of them
  int draws = 500;
  std::uint32_t seed = 1;
  double most_cells = 3.0;           ///< of each coordinate of the offset
  double most_turn = radians(10.0);  ///< [rad]

  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

struct OffsetDraw {
  Pose2 T_map_first{}, T_first_second{};  ///< truth
  Offset found;
  double error_cells = 0.0;
  double error_turn = 0.0;  ///< [rad]

  /// Less than half a cell and one degree off.
  [[nodiscard]] bool succeeded() const { return error_cells < 0.5 && error_turn < radians(1.0); }
  [[nodiscard]] bool claims_all() const { return found.estimated && found.observed_directions == 3; }
};

/// How much of each cell of `frame`, laid at `T_map_frame`, lies within `half_wall_m` of a surface: 4 x 4 points each.
Grid<double> drawn_occupancy(const World& world, const Pose2& T_map_frame, const GridFrame& frame, double half_wall_m);

/// Pairs of partial maps at random places of the hallway, offset at random. The estimate starts at no offset at all.
/// The same for any number of threads.
std::vector<OffsetDraw> run_offset_study(const OffsetStudy& study, Workers& workers);

/// Medians and successes, over all draws and over those of which the estimate says that it saw all three directions.
struct OffsetSummary {
  int draws = 0, succeeded = 0;
  double median_cells = 0.0, median_turn = 0.0;  ///< [rad]
  int claimed = 0, claimed_succeeded = 0;        ///< all three directions observed
  int partly = 0, not_estimated = 0;
};
OffsetSummary summarise(const std::vector<OffsetDraw>& draws);
std::string offset_table(const OffsetSummary& summary);
std::string offset_csv(const std::vector<OffsetDraw>& draws);

}  // namespace cogslam
