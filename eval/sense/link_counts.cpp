#include "eval/sense/link_counts.hpp"

#include <fmt/format.h>

namespace cogslam {

void LinkCounts::add(const Offset& offset) {
  ++all;
  if (!offset.estimated) ++not_estimated;
  if (!offset.overlaps) ++no_overlap;
  if (offset.estimated && offset.observed_directions < 3) ++not_observed;
}

void expect_overlap(const LinkCounts& links, const OffsetConfig& config, const SourcePlace& place) {
  if (links.all == 0 || links.no_overlap < links.all) return;
  throw InputError(place,
                   fmt::format("none of {} links between partial maps has {} cells in common, expected a smaller "
                               "step or larger maps",
                               links.all, config.least_overlap_cells));
}

}  // namespace cogslam
