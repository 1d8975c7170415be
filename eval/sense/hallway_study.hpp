#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "eval/sense/link_counts.hpp"
#include "eval/sense/path_correction.hpp"

namespace cogslam {

/// One drive through the hallway.
struct HallwayRun {
  std::vector<PathLook> looks;
  std::vector<CorrectedLook> corrected;
};

/// Drives hallway_route() through hallway() and corrects the path.
HallwayRun run_hallway(const PathDriveConfig& drive, const PathCorrectionConfig& correction, std::uint32_t seed);

/// What the correction gained on one drive.
struct HallwayScore {
  std::uint32_t seed = 0;
  PathDeviation odometry, corrected;
  LinkCounts links;
};

struct HallwayStudy {
  PathDriveConfig drive{};
  PathCorrectionConfig correction{};
  std::uint32_t first_seed = 1;
  int seeds = 10;
};

HallwayScore score_hallway(const HallwayRun& run, std::uint32_t seed);

/// One score for each seed. The same for any number of threads. Throws InputError where on one drive no partial map
/// overlaps the one before (expect_overlap).
std::vector<HallwayScore> run_hallway_study(const HallwayStudy& study, Workers& workers);

std::string hallway_table(const std::vector<HallwayScore>& scores);
std::string hallway_csv(const std::vector<HallwayScore>& scores);

}  // namespace cogslam
