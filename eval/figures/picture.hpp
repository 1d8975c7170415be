#pragma once

#include <string>
#include <vector>

#include "eval/figures/measured_sweep.hpp"
#include "eval/report/chart.hpp"

// Charts of single episodes: paths in a room, and maps.

namespace cogslam {

/// A path by name.
struct NamedPath {
  std::string name;
  std::vector<Pose2> poses;
};

/// The room's surfaces and paths through it, x and y to one scale.
Chart path_chart(const std::string& title, const World& world, const std::vector<NamedPath>& paths);

/// Probabilities, saturated as they are scored: white free, grey unknown, black occupied; alike in all pictures of maps
/// that reach both ends of the saturation.
Chart map_chart(const std::string& title, const std::string& below, const Grid<float>& log_odds);

/// Lines for the head `kPictureHead`: a pose each, and a cell each.
std::string path_csv(const NamedPath& path);
std::string map_csv(const std::string& name, const Grid<float>& log_odds);

inline constexpr const char* kPictureHead = "kind,name,reading,row,column,x_m,y_m,probability\n";

std::vector<Pose2> true_path(const TruthLog& truth);

}  // namespace cogslam
