#include "eval/filter_degradation.hpp"

namespace cogslam {
namespace {

/// Whether `count` is at least `least`, and at least this share of `all`.
bool many(std::int64_t count, std::int64_t all, double share, std::int64_t least) {
  return count >= least && static_cast<double>(count) >= share * static_cast<double>(all);
}

}  // namespace

std::vector<Degradation> degradations(const FilterHealth& health) {
  std::vector<Degradation> found;
  const auto note = [&](bool seen, const Degradation& what) {
    if (seen) found.push_back(what);
  };
  note(many(health.scans_missing, health.records, 0.02, 5), kScansMissing);
  note(health.repeated_scans >= 3, kRepeatedScans);
  note(many(health.blind_scans, health.records, 0.02, 3), kBlindScans);
  note(health.by_camera > 1 && many(health.by_wheels, health.by_camera + health.by_wheels, 0.02, 5), kCameraBlind);
  note(many(health.odometry_doubted, health.odometry_checks, 0.02, 2), kOdometryDoubted);
  note(many(health.headings_doubted, health.headings, 0.02, 3), kHeadingsDoubted);
  note(many(health.beams_doubted, health.beams_known, 0.1, 500), kBeamsDoubted);
  note(health.longest_doubt >= 10, kLost);
  note(many(health.collapses, health.scans_judged, 0.2, 5), kParticlesCollapsed);
  return found;
}

}  // namespace cogslam
