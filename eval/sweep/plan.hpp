#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cogslam {

/// One variant on one set of readings: the unit of a sweep.
struct PlannedEpisode {
  std::string key;  ///< 16 hexadecimal digits: of everything that can change the scores
  std::string world;
  std::string variant;
  std::string baseline;  ///< the variant that it is compared with; empty where it is the first of its kind
  double cell_size = 0.0;
  std::uint32_t seed = 0;
  bool true_poses = false;
  int particles = 0;
  std::string readings_key;  ///< of the readings: episodes with the same are given the same
  std::string own_key;       ///< of this variant alone, whatever it is compared with
  std::string baseline_key;  ///< `own_key` of the baseline, empty where there is none
  std::string scenario;      ///< resolved: the baseline, where there is one, then the variant
};

/// All episodes of a sweep, in the order of its tables: world, cell size, variant, seed.
struct SweepPlan {
  std::string name;
  std::vector<PlannedEpisode> episodes;
};

/// Reads a sweep file (docs/sweeps.md) and every scenario that it names. Throws InputError with file:line:column for
/// anything that is not right.
SweepPlan load_sweep(const std::filesystem::path& file);

}  // namespace cogslam
