#pragma once

#include <set>
#include <string>
#include <vector>

#include "eval/page/html.hpp"
#include "eval/sweep/summary.hpp"

namespace cogslam {

/// What a sweep's page is made of; it lies in the sweep's folder and links to files beside it.
struct SweepPageData {
  std::string name;
  std::size_t planned = 0;  ///< episodes of the plan
  const EpisodeTable& table;
  std::vector<VariantSummary> summary;
  std::set<std::string> pages{};  ///< keys of the episodes that have a page of their own
};

/// Episodes that the page lists one by one; of larger sweeps only the first.
constexpr std::size_t kEpisodesListed = 3000;

/// A sweep as a self-contained HTML document: curves with their 95 % intervals, a table of variants, and every episode
/// with its files and the command that replays it. Without a script in `parts` the curves are pictures. Costs are left
/// out: the same sweep has the same page, byte for byte.
std::string sweep_page(const SweepPageData& data, const PageParts& parts);

}  // namespace cogslam
