#pragma once

#include <optional>
#include <string>

#include "sensors/readings.hpp"
#include "worlds/world.hpp"

namespace cogslam {

// What files from outside may say. The limits lie far beyond any robot; within them no figure overflows and no map
// grows without bound before the filter can say so.

constexpr double kFarthest = 1e6;           ///< of a position from its origin [m]
constexpr double kLongestMotion = 1000.0;   ///< from one record to the next [m]
constexpr double kFastest = 1e6;            ///< [m/s, rad/s]
constexpr double kFarthestMount = 100.0;    ///< of a lidar from the base [m]
constexpr double kLatestStamp = 4.6e9;      ///< [s]; differences still fit into 64 bits of nanoseconds
constexpr std::size_t kMostBeams = 100000;  ///< of a scan

/// What is wrong with a reading that a file holds ("the motion is not finite, expected ..."), or nothing: all figures
/// finite and within the limits above, the covariance symmetric and not negative, ranges as Scan says.
std::optional<std::string> defect(const Reading& reading);

/// The same of a pose in the map or odometry frame.
std::optional<std::string> defect(const Pose2& pose);

/// The same of a world: at least one surface, finite, at most kLargestRoom each way.
std::optional<std::string> defect(const World& world);

}  // namespace cogslam
