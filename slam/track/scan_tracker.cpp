#include "slam/track/scan_tracker.hpp"

#include <algorithm>
#include <cmath>

#include <limits>

#include "core/check.hpp"
#include "core/error.hpp"

namespace cogslam {
namespace {

constexpr double kSureTurn = 0.05;  // rad: a better known turn needs no search
constexpr double kSearchSigmas = 2.5;
constexpr int kSearchSteps = 8;           // on either side
constexpr double kWideStep = 0.5;         // m
constexpr int kWideTurns = 10;            // on either side
constexpr double kDoubtful = 0.25;        // share of contradictions from which on a match is doubted
constexpr double kClearlyLess = 0.7;      // a wide match must cost so many times less to be believed
constexpr std::size_t kSearchStride = 4;  // the search pairs every fourth point

std::vector<SurfacePoint> thinned(const std::vector<SurfacePoint>& points) {
  std::vector<SurfacePoint> some;
  for (std::size_t i = 0; i < points.size(); i += kSearchStride) some.push_back(points[i]);
  return some;
}

/// Share of contradictions among the points of which the local map knows anything.
double doubt(const PointToLineMatch& match) {
  return match.contradicted_share / std::max(1e-9, match.contradicted_share + match.paired_share);
}

}  // namespace

void TrackerConfig::check() const {
  EXPECTS(keys > 0 && beams > 0 && gap > 0.0 && cell > 0.0 && turn_step > 0.0);
  if (match.last_reach > match.first_reach) throw InputError("tracker: last_reach_m must not exceed first_reach_m");
}

ScanTracker::ScanTracker(const TrackerConfig& config, const SweepConfig& sweep)
    : config_(config), sweep_(sweep), map_(config.keys, config.cell, config.match.first_reach) {
  config.check();
  sweep_.beams = config.beams;
}

void ScanTracker::follow(const Reading& reading) {
  const MotionIncrement& motion = reading.motion;
  T_scan_now_ = T_scan_now_ * motion.T_before_now;
  since_scan_ = compose_covariance(since_scan_, motion.T_before_now, motion.covariance);
  if (lagging_) *lagging_ = *lagging_ * motion.T_before_now;
  if (reading.scan) match(reading);
}

void ScanTracker::match(const Reading& reading) {
  beams_ = sweep_of(reading, sweep_);
  points_ = surface_points(beams_, config_.gap);
  const Pose2 predicted = T_track_base();
  const Eigen::Matrix3d covariance = motion_covariance();
  PointToLineMatch match = search_turns(predicted, covariance);
  if (lagging_) {  // odometry may have caught up by now
    const PointToLineMatch other = search_turns(*lagging_, covariance);
    if (other.cost < match.cost) match = other;
  }
  lagging_.reset();
  if (doubt(match) > kDoubtful) {
    const PointToLineMatch wide = search_wide(predicted, covariance);
    if (doubt(wide) < 0.5 * doubt(match) && wide.cost < kClearlyLess * match.cost) {
      match = wide;
      lagging_ = predicted;
    }
  }
  T_track_scan_ = match.T_map_base;
  scan_covariance_ = match.covariance;
  T_scan_now_ = Pose2{};
  since_scan_.setZero();
}

/// Of the motion that odometry tells since the last scan.
Eigen::Matrix3d ScanTracker::motion_covariance() const {
  Eigen::Matrix3d covariance = config_.inflation * config_.inflation * since_scan_;
  const double position = config_.least_sigma_position, heading = config_.least_sigma_heading;
  covariance.diagonal() += Eigen::Vector3d(position * position, position * position, heading * heading);
  return covariance;
}

/// After a sharp turn point pairs lead astray: the search starts from several headings, and the best match is kept.
PointToLineMatch ScanTracker::search_turns(const Pose2& predicted, const Eigen::Matrix3d& covariance) const {
  std::vector<Pose2> starts{predicted};
  const double sigma = std::sqrt(covariance(2, 2));
  if (sigma > kSureTurn) {
    const int steps = std::min(kSearchSteps, static_cast<int>(std::ceil(kSearchSigmas * sigma / config_.turn_step)));
    for (int k = -steps; k <= steps; ++k) starts.push_back(predicted * Pose2{0.0, 0.0, k * config_.turn_step});
  }
  return best_match(starts, predicted, covariance);
}

/// The scan does not fit where odometry leads: records of real logs lag behind their scans by a step now and then, and
/// then make up for it at once. So the motion is sought within a wide reach, and taken if the scan fits there.
PointToLineMatch ScanTracker::search_wide(const Pose2& predicted, const Eigen::Matrix3d& covariance) const {
  std::vector<Pose2> starts;
  for (const double x : {-2 * kWideStep, -kWideStep, 0.0, kWideStep, 2 * kWideStep}) {
    for (const double y : {-kWideStep, 0.0, kWideStep}) {
      for (int k = -kWideTurns; k <= kWideTurns; ++k) {
        starts.push_back(predicted * Pose2{x, y, k * config_.turn_step});
      }
    }
  }
  Eigen::Matrix3d wide = covariance;
  const double turn = kWideTurns * config_.turn_step / 2.0;
  wide.diagonal() += Eigen::Vector3d(4.0 * kWideStep * kWideStep, kWideStep * kWideStep, turn * turn);
  return best_match(starts, predicted, wide);
}

PointToLineMatch ScanTracker::best_match(const std::vector<Pose2>& starts, const Pose2& predicted,
                                         const Eigen::Matrix3d& covariance) const {
  Pose2 start = starts.front();
  if (starts.size() > 1 && !map_.empty()) {
    const std::vector<SurfacePoint> some = thinned(points_);
    double least = std::numeric_limits<double>::infinity();
    for (const Pose2& from : starts) {
      const PointToLineMatch match = match_points(some, map_, predicted, covariance, config_.match, from);
      if (match.cost >= least) continue;
      least = match.cost;
      start = match.T_map_base;
    }
  }
  return match_points(points_, map_, predicted, covariance, config_.match, start);
}

void ScanTracker::make_key() {
  map_.add(points_, RangeView(beams_), T_track_scan_);
  T_track_key_ = T_track_scan_;
}

Eigen::Matrix3d ScanTracker::covariance() const {
  return compose_covariance(scan_covariance_, T_scan_now_, config_.inflation * config_.inflation * since_scan_);
}

Eigen::Matrix3d ScanTracker::spread() const {
  const double position = config_.spread_position, heading = config_.spread_heading;
  Eigen::Matrix3d spread = config_.spread * config_.spread * covariance();
  spread.diagonal() += Eigen::Vector3d(position * position, position * position, heading * heading);
  return spread;
}

}  // namespace cogslam
