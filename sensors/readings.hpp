#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/pose2.hpp"
#include "core/time.hpp"

// All that SLAM is ever told. The truth goes another way (sensors/log/truth_log.hpp), which slam/ cannot include.

namespace cogslam {

/// A sweep of range readings, beam 0 first, counter-clockwise. Seen from the lidar: x forward, y left.
struct Scan {
  static constexpr float kNoReturn = std::numeric_limits<float>::infinity();   ///< nothing within range (REP-117)
  static constexpr float kTooClose = -std::numeric_limits<float>::infinity();  ///< something nearer than range_min
  static constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();   ///< the beam says nothing at all

  double angle_first = 0.0;      ///< direction of beam 0 [rad]
  double angle_increment = 0.0;  ///< from one beam to the next [rad]
  double range_min = 0.0;        ///< [m]
  double range_max = 0.0;        ///< [m]; a beam of kNoReturn is free up to here
  Duration time_increment{};     ///< from one beam to the next; 0: all at once
  Pose2 T_base_lidar{};          ///< mounting
  std::vector<float> ranges;     ///< [m], finite within [range_min, range_max], or one of the three values above

  bool operator==(const Scan&) const = default;
};

/// What told us of the motion.
enum class MotionSource : std::uint8_t {
  kVisual = 0,  ///< floor camera
  kWheel = 1,   ///< wheel encoders: the declared fallback where the camera has no estimate
  kLog = 2,     ///< odometry of a foreign log
};

/// Motion of the base since the reading before, and how far it is to be trusted.
struct MotionIncrement {
  Pose2 T_before_now{};                                  ///< pose of the base now, seen from the reading before
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the small motion that follows it [m, m, rad]
  MotionSource source = MotionSource::kVisual;
};

/// One step's evidence. `sequence` is the order; the stamp is a label (stamps of real logs jump backwards).
struct Reading {
  std::uint64_t sequence = 0;
  Time stamp{};                     ///< of the scan's first beam
  MotionIncrement motion{};         ///< since the reading before; identity in the first
  Twist2 twist{};                   ///< of the base during the sweep, as odometry saw it; zero where not known
  std::optional<Scan> scan{};       ///< nothing: an odometry-only record
  std::optional<double> heading{};  ///< of the base, counter-clockwise from the map's +x [rad]; with bias and noise
};

// What the odometry front end (slam/odometry) turns into readings, once per run.

/// A grey picture of the floor, row 0 at the top.
struct FloorImage {
  Time stamp{};  ///< middle of the exposure
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;  ///< row-major, width x height
};

/// Angles of the four wheels since the start [rad]: front left, front right, rear left, rear right.
struct WheelSample {
  Time stamp{};
  std::array<double, 4> angles{};
};

/// Heading of the base in the map, counter-clockwise from +x [rad].
struct CompassSample {
  Time stamp{};
  double heading = 0.0;
};

/// A sweep and the moment of its first beam; without ranges where one was due, but none came.
struct ScanSample {
  Time stamp{};
  Scan scan;
};

}  // namespace cogslam
