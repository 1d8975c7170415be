#pragma once

#include "core/error.hpp"
#include "slam/mobile_sensing/offset.hpp"

namespace cogslam {

/// What became of the links of a path: pairs of partial maps, one after the other.
struct LinkCounts {
  int all = 0;
  int not_estimated = 0;  ///< kept odometry
  int no_overlap = 0;     ///< those of them whose maps have too few cells in common
  int not_observed = 0;   ///< estimated, with a direction that kept odometry

  void add(const Offset& offset);
};

/// Throws InputError where there are links and none has overlap: "none of N links between partial maps has M cells in
/// common, expected a smaller step or larger maps".
void expect_overlap(const LinkCounts& links, const OffsetConfig& config, const SourcePlace& place = {});

}  // namespace cogslam
