#pragma once

#include <string>

#include "eval/page/sweep_page.hpp"

// The tables of a sweep's page, as HTML. A cell with a figure has the attribute data-value: the exact number.

namespace cogslam {

/// A row per variant, world and cell size: means with 95 % intervals, and differences to the baseline.
std::string variants_table(const SweepPageData& data);

/// A row per episode, with links to its files and the command that replays it; at most kEpisodesListed.
std::string episodes_table(const SweepPageData& data);

}  // namespace cogslam
