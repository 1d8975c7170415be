#pragma once

#include <string_view>
#include <vector>

#include "core/grid.hpp"
#include "sensors/log/recording.hpp"
#include "slam/sweep.hpp"

namespace cogslam {

/// A way in which a run measured less than its scores suggest: a key for scores.json and what it means, for people.
struct Degradation {
  std::string_view key;
  std::string_view words;
};

/// No beam of any scan ended on a surface.
inline constexpr Degradation kNoReturns{"no_returns",
                                        "no beam of any scan came back from a surface: the path is odometry's"};
/// Every cell of the map is as it was at the start.
inline constexpr Degradation kEmptyMap{"empty_map",
                                       "no scan changed the map: look at the map's area and the lidar's range"};

/// What is to be said of a run that came to an end: of its readings, as the filter's `sweep` looks at them, and of its
/// final map of log-odds.
std::vector<Degradation> degradations(const Recording& recording, const SweepConfig& sweep, const Grid<float>& map);

}  // namespace cogslam
