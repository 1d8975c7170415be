#pragma once

#include <cstdint>
#include <optional>

namespace cogslam {

/// What the scan registered last left behind; bytes are per particle as below.
struct LastScan {
  double effective_particles = 0.0;  ///< effective sample size of the weights, before any resampling
  bool resampled = false;
  double payload_bytes = 0.0;
  double bytes = 0.0;
};

/// What the filter went through. Byte figures are per particle, shared blocks divided among their sharers.
struct FilterStatistics {
  std::int64_t registered = 0;  ///< scans that were matched and weighed, and enter the maps
  std::int64_t tracked = 0;     ///< the other scans: they only told of motion
  std::int64_t resamplings = 0;
  double payload_bytes = 0.0;  ///< map values alone, mean over registered scans
  double bytes = 0.0;          ///< all-in: headers, directories, heap padding, pose and path tree; mean
  double bytes_peak = 0.0;
  LastScan last{};
  std::optional<double> ancestors_100;  ///< distinct ancestors 100 registered scans back, at the end; nothing: too
                                        ///< short a path, or more than 100 scans wait
};

}  // namespace cogslam
