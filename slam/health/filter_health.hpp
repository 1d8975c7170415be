#pragma once

#include <cstdint>

namespace cogslam {

/// Signs that readings and belief do not go together, counted while the filter works. They change nothing that it
/// believes; eval/filter_degradation.hpp says from when on they are a warning.
struct FilterHealth {
  std::int64_t records = 0;           ///< readings taken
  std::int64_t scans_missing = 0;     ///< of those: without a scan, which was due and did not come
  std::int64_t blind_scans = 0;       ///< scans of which hardly a beam came back
  std::int64_t repeated_scans = 0;    ///< scans equal to the one before although the robot moved
  std::int64_t by_camera = 0;         ///< readings whose motion the floor camera told
  std::int64_t by_wheels = 0;         ///< readings whose motion wheels told
  std::int64_t odometry_checks = 0;   ///< stretches over which odometry was compared with the tracker
  std::int64_t odometry_doubted = 0;  ///< of those: they contradict each other
  std::int64_t headings = 0;          ///< that were weighed
  std::int64_t headings_doubted = 0;  ///< of those: too far from what the best particle expected
  std::int64_t scans_judged = 0;      ///< registered scans of which the best particle's map knew enough
  std::int64_t scans_doubted = 0;     ///< of those: the map contradicts them
  std::int64_t beams_known = 0;       ///< beams of judged scans that end in cells of which the map knows anything
  std::int64_t beams_doubted = 0;     ///< of those: far from all that it calls occupied
  std::int64_t longest_doubt = 0;     ///< most of them in a row
  std::int64_t collapses = 0;         ///< registered scans after which hardly a particle was left that counts

  bool operator==(const FilterHealth&) const = default;
};

}  // namespace cogslam
