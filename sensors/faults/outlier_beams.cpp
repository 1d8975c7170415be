#include "sensors/faults/outlier_beams.hpp"

#include <algorithm>

#include "core/rng.hpp"

namespace cogslam {

OutlierBeams read_outlier_beams(ConfigSection& section, std::uint32_t number) {
  OutlierBeams fault{.number = number};
  section.read("share", fault.share, {0.0, 1.0});
  section.read("shortest_m", fault.shortest, {0.0, 1000.0});
  section.read("longest_m", fault.longest, {0.0, 1000.0});
  if (fault.shortest >= fault.longest) {
    section.fail("longest_m", "longest_m is not above shortest_m, expected shortest_m < longest_m");
  }
  fault.span = read_fault_span(section);
  return fault;
}

void add_outliers(const OutlierBeams& fault, std::uint32_t seed, std::uint64_t index, Scan& scan) {
  Rng rng({.seed = seed, .purpose = Purpose::kSensorFault, .entity = fault.number, .tick = index});
  const float nearest = static_cast<float>(scan.range_min), farthest = static_cast<float>(scan.range_max);
  for (float& range : scan.ranges) {
    // Drawn for every beam, used or not: one beam's luck must not change the next one's.
    const bool hit = rng.uniform() < fault.share;
    const auto anywhere = static_cast<float>(rng.uniform(fault.shortest, fault.longest));
    if (hit) range = std::clamp(anywhere, nearest, farthest);
  }
}

}  // namespace cogslam
