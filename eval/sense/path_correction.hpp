#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eval/sense/path_drive.hpp"
#include "slam/mobile_sensing/offset_chain.hpp"
#include "slam/mobile_sensing/partial_map.hpp"

namespace cogslam {

/// How a drive is corrected.
struct PathCorrectionConfig {
  PartialMapConfig map{};
  OffsetConfig offset{.observable_share = 0.05};  ///< odometry is a good prior: stricter than by default
  int samples = 1536;  ///< cells of each partial map that are measured; the others are recovered

  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

/// One look, corrected.
struct CorrectedLook {
  Pose2 T_map_base{};            ///< from the truth at the start on
  PartialMap map;                ///< as recovered from the samples
  std::optional<Offset> offset;  ///< to the look before
};

/// Partial maps, offsets and poses of a drive. The seed is that of the sampled cells.
std::vector<CorrectedLook> correct_path(std::span<const PathLook> looks, const PathCorrectionConfig& config,
                                        std::uint32_t seed);

/// Root mean squares over the looks of a drive.
struct PathDeviation {
  double heading = 0.0;  ///< [rad]
  double across = 0.0;   ///< the corridor [m]
  double along = 0.0;    ///< the corridor [m]
};

/// Of poses in the map, one for each look; across and along are told by the true leg.
PathDeviation path_deviation(std::span<const PathLook> looks, std::span<const Pose2> T_map_base);

}  // namespace cogslam
