#pragma once

#include <string>
#include <vector>

#include "eval/lab/map_study.hpp"

namespace cogslam {

/// A line per combination: everything but the times, so that runs can be compared.
std::string map_csv(const std::vector<MapScore>& scores);
/// The same for people, with times; combinations that do not exist say why.
std::string map_table(const std::vector<MapScore>& scores);
/// Bytes, bits per cell and errors of the yardsticks on this map.
std::string yardstick_table(const Grid<float>& map);

}  // namespace cogslam
