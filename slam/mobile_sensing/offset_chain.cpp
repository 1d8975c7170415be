#include "slam/mobile_sensing/offset_chain.hpp"

#include <utility>

namespace cogslam {

std::optional<Offset> OffsetChain::push(PartialMap map, const Pose2& T_before_now) {
  std::optional<Offset> offset;
  if (before_) {
    offset = estimate_offset(*before_, map, T_before_now, config_);
    T_map_base_ = T_map_base_ * offset->T_first_second;
  }
  before_ = std::move(map);
  return offset;
}

}  // namespace cogslam
