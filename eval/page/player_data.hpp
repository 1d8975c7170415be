#pragma once

#include <string>
#include <vector>

#include "eval/run_folder.hpp"

namespace cogslam {

/// What the player shows, as it stands in the page: a description in JSON, and packed columns (PackedColumns::text).
struct PlayerData {
  std::string json;
  std::vector<std::string> packs;  ///< first that of all variants together, then one per variant of the description

  [[nodiscard]] std::size_t bytes() const;
};

/// Of runs that kept a trace. `coarser` halves, so many times, frames and states of the maps; of the runs the first
/// `variants` are described. Nothing (no packs) where no run kept a trace.
///
/// Lengths are rounded to 0.1 mm and angles to 0.1 mrad in paths, to 1 cm in scans, to 1 mm and 1 mrad in clouds.
PlayerData player_data(const RunFiles& files, unsigned coarser, std::size_t variants);

/// The finest that takes at most `most` bytes; nothing where not even the coarsest of one variant does.
PlayerData player_data_within(const RunFiles& files, std::size_t most);

}  // namespace cogslam
