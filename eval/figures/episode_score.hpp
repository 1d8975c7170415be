#pragma once

#include <optional>
#include <string>

#include "eval/figures/measured_sweep.hpp"

namespace cogslam {

/// The row of an episode; nothing where it was not measured.
std::optional<std::size_t> episode_row(const EpisodeTable& table, const EpisodeName& name);
/// A number of that row; nothing where there is none.
std::optional<double> episode_score(const EpisodeTable& table, const EpisodeName& name, const std::string& column);

}  // namespace cogslam
