#pragma once

#include <optional>

#include "slam/health/filter_health.hpp"
#include "slam/weight/scan_likelihood.hpp"

namespace cogslam {

/// What the best particle made of a registered scan.
struct BestLook {
  ScanAgreement scan{};
  std::optional<double> heading_sigmas{};  ///< of the compass's innovation; nothing: no heading
};

/// Watches registered scans: does the map know them, does the heading fit, do enough particles count?
class MapWatch {
 public:
  /// `effective`: effective sample size of `particles` particles after the scan.
  void see(const BestLook& look, double effective, int particles, FilterHealth& health);

 private:
  std::int64_t in_a_row_ = 0;
};

}  // namespace cogslam
