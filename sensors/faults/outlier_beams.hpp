#pragma once

#include <cstdint>

#include "core/config.hpp"
#include "sensors/faults/fault_span.hpp"
#include "sensors/readings.hpp"

namespace cogslam {

/// Beams that come back from anywhere: dust, rain, sunlight, other lidars.
struct OutlierBeams {
  FaultSpan span{};
  double share = 0.1;        ///< of all beams, each by chance
  double shortest = 0.1;     ///< they read anything from here [m]
  double longest = 30.0;     ///< to here [m]
  std::uint32_t number = 0;  ///< in the list of faults: names its draws
};

/// `share`, `shortest_m`, `longest_m`, `from_s`, `to_s`. InputError where shortest_m is not below longest_m.
OutlierBeams read_outlier_beams(ConfigSection& section, std::uint32_t number);

/// Changes the ranges of sweep number `index`, within the limits of the scan.
void add_outliers(const OutlierBeams& fault, std::uint32_t seed, std::uint64_t index, Scan& scan);

}  // namespace cogslam
