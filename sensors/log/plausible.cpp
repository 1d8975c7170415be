#include "sensors/log/plausible.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "worlds/rooms.hpp"

namespace cogslam {
namespace {

constexpr double kWidestAngle = 10.0;                 // rad; wrapped ones are within pi
constexpr double kLargestVariance = 1e6;              // m^2, rad^2
constexpr double kRounding = 1e-6;                    // share
constexpr std::int64_t kSlowestBeam = 1'000'000'000;  // ns

/// NaN is not within.
bool within(double value, double limit) { return std::abs(value) <= limit; }

bool within(const Pose2& pose, double limit) {
  return within(pose.x, limit) && within(pose.y, limit) && within(pose.theta, kWidestAngle);
}

/// Symmetric, and no direction has a negative variance; rounding may have touched either.
bool is_covariance(const Eigen::Matrix3d& c) {
  for (int i = 0; i < 3; ++i) {
    if (!(c(i, i) >= 0.0 && c(i, i) <= kLargestVariance)) return false;
    for (int j = 0; j < i; ++j) {
      const double most = std::sqrt(c(i, i) * c(j, j)) * (1.0 + kRounding);
      if (!(within(c(i, j), most) && within(c(i, j) - c(j, i), kRounding * most))) return false;
    }
  }
  return c.determinant() >= -kRounding * c.diagonal().prod();
}

bool is_range(float range, const Scan& scan) {
  if (!std::isfinite(range)) return true;  // the three values that Scan names
  return range >= 0.0F && static_cast<double>(range) <= scan.range_max * (1.0 + kRounding);
}

std::optional<std::string> defect(const Scan& scan) {
  if (!within(scan.angle_first, kWidestAngle) || !within(scan.angle_increment, kWidestAngle)) {
    return "the scan's angles are not finite or too wide, expected at most 10 rad";
  }
  if (!(scan.range_min >= 0.0 && scan.range_min <= scan.range_max && scan.range_max <= kFarthest)) {
    return "the scan's limits are wrong, expected 0 <= range_min <= range_max <= 1e6 m";
  }
  if (scan.time_increment.ns < 0 || scan.time_increment.ns > kSlowestBeam) {
    return "the scan's time between beams is out of range, expected 0 to 1 s";
  }
  if (!within(scan.T_base_lidar, kFarthestMount)) {
    return "the lidar's mounting is not finite or too far off, expected at most 100 m";
  }
  if (scan.ranges.size() > kMostBeams) return "the scan has too many beams, expected at most 100000";
  if (!std::all_of(scan.ranges.begin(), scan.ranges.end(), [&](float r) { return is_range(r, scan); })) {
    return "a range is negative or too long, expected 0 to range_max";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> defect(const Pose2& pose) {
  if (within(pose, kFarthest)) return std::nullopt;
  return "the pose is not finite or too far off, expected at most 1e6 m";
}

std::optional<std::string> defect(const Reading& reading) {
  if (!within(static_cast<double>(reading.stamp.ns), kLatestStamp * 1e9)) {
    return "the stamp is out of range, expected at most 4.6e9 s";
  }
  if (!within(reading.motion.T_before_now, kLongestMotion)) {
    return "the motion is not finite or too far, expected at most 1000 m";
  }
  if (!is_covariance(reading.motion.covariance)) {
    return "the motion's covariance is none, expected a symmetric matrix without negative eigenvalues";
  }
  const Twist2& twist = reading.twist;
  if (!within(twist.x, kFastest) || !within(twist.y, kFastest) || !within(twist.theta, kFastest)) {
    return "the twist is not finite or too fast, expected at most 1e6 m/s and rad/s";
  }
  if (reading.heading && !within(*reading.heading, kWidestAngle)) {
    return "the heading is not finite or too large, expected at most 10 rad";
  }
  return reading.scan ? defect(*reading.scan) : std::nullopt;
}

std::optional<std::string> defect(const World& world) {
  const std::vector<Segment> surfaces = world.segments();
  if (surfaces.empty()) return "the world has no surface, expected at least one wall";
  for (const Segment& surface : surfaces) {
    if (!surface.a.allFinite() || !surface.b.allFinite()) return "a corner of the world is not finite, expected metres";
  }
  const Rectangle bounds = world.bounds();
  if (!((bounds.max - bounds.min).maxCoeff() <= kLargestRoom && within(bounds.min.x(), kFarthest) &&
        within(bounds.min.y(), kFarthest))) {
    return "the world is too large or too far off, expected at most 200 m each way";
  }
  for (const SlipPatch& patch : world.slip_patches) {
    if (!patch.centre.allFinite() || !(patch.radius > 0.0 && patch.radius <= kFarthest) ||
        !(patch.friction >= 0.0 && patch.friction <= 1.0)) {
      return "a slip patch is wrong, expected finite figures, a radius above 0 and friction in [0, 1]";
    }
  }
  return defect(world.start);
}

}  // namespace cogslam
