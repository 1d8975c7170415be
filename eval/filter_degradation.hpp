#pragma once

#include <vector>

#include "eval/degradation.hpp"
#include "slam/health/filter_health.hpp"

namespace cogslam {

inline constexpr Degradation kScansMissing{"scans_missing", "readings without a scan: the lidar was silent"};
inline constexpr Degradation kBlindScans{"blind_scans", "scans of which hardly a beam came back"};
inline constexpr Degradation kRepeatedScans{"repeated_scans",
                                            "the same scan came again although the robot moved: the lidar is frozen"};
inline constexpr Degradation kCameraBlind{"camera_blind",
                                          "the floor camera gave no motion for a part of the way: wheels stood in"};
inline constexpr Degradation kOdometryDoubted{"odometry_doubted",
                                              "odometry and scans contradict each other: one of them is wrong or late"};
inline constexpr Degradation kHeadingsDoubted{
    "headings_doubted", "headings that cannot be: the compass is disturbed, or the pose is wrong"};
inline constexpr Degradation kBeamsDoubted{"beams_doubted",
                                           "many beams end where the map has nothing: stray beams, or a wrong map"};
inline constexpr Degradation kLost{"lost", "scan after scan contradicts the map: the pose is probably wrong"};
inline constexpr Degradation kParticlesCollapsed{"particles_collapsed",
                                                 "one particle outweighed all others too often: too few, or all wrong"};

/// What is to be said of a filter that counted these signs. The limits lie above what runs without any fault show
/// (docs/faults.md).
std::vector<Degradation> degradations(const FilterHealth& health);

}  // namespace cogslam
