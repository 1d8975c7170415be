#include "slam/odometry/front_end.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/angle.hpp"
#include "core/check.hpp"
#include "core/error.hpp"

namespace cogslam {
namespace {

template <class Sample>
bool in_order(const std::deque<Sample>& earlier, const Sample& sample) {
  return earlier.empty() || earlier.back().stamp <= sample.stamp;
}

Duration sweep_of(const Scan& scan) {
  const auto beams = static_cast<std::int64_t>(scan.ranges.size());
  return beams > 1 ? (beams - 1) * scan.time_increment : Duration{};
}

Time middle_of(const ScanSample& sample) { return sample.stamp + Duration{sweep_of(sample.scan).ns / 2}; }

}  // namespace

OdometryFrontEnd::OdometryFrontEnd(const OdometryConfig& config, const std::optional<CameraModel>& camera,
                                   const std::optional<MecanumGeometry>& wheels)
    : config_(config), geometry_(wheels) {
  if (!camera && !wheels) {
    throw InputError("odometry has nothing to work with, expected a floor camera, wheel encoders or both");
  }
  if (config.source == OdometrySource::kWheel && !wheels) {
    throw InputError("odometry source is `wheel`, but there are no wheel encoders");
  }
  if (camera && config.source == OdometrySource::kVisual) {
    camera_ = *camera;
    visual_ = std::make_unique<VisualOdometry>(*camera, config.visual);
  }
}

OdometryFrontEnd::~OdometryFrontEnd() = default;

void OdometryFrontEnd::add(const FloorImage& image) {
  if (!visual_) return;
  const bool first = !std::exchange(seen_image_, true);
  std::optional<MotionIncrement> motion = motion_to(image);
  start_at(image.stamp);
  if (image.stamp <= track_.end()) return;  // the very first
  if (!first) {
    ++spans_seen_;
    spans_without_ += motion ? 0U : 1U;
  }
  spans_.push_back({image.stamp, std::move(motion)});
  settle();
}

/// Noise tells two pictures apart even where nothing moves: one that equals the last is no new picture. What follows
/// is not compared with it, or the motion that the wheels told in between would be told again.
std::optional<MotionIncrement> OdometryFrontEnd::motion_to(const FloorImage& image) {
  const bool repeated = image.grey == last_grey_;
  last_grey_ = image.grey;
  if (repeated) {
    ++pictures_repeated_;
    visual_ = std::make_unique<VisualOdometry>(camera_, config_.visual);
    return std::nullopt;
  }
  return visual_->update(image);
}

void OdometryFrontEnd::add(const WheelSample& sample) {
  EXPECTS(in_order(wheels_, sample));
  if (!geometry_ || (!wheels_.empty() && sample.stamp == wheels_.back().stamp)) return;
  start_at(sample.stamp);
  wheels_.push_back(sample);
  if (!visual_ && sample.stamp > track_.end()) spans_.push_back({sample.stamp, std::nullopt});
  settle();
}

void OdometryFrontEnd::add(const CompassSample& sample) {
  EXPECTS(in_order(compass_, sample));
  compass_.push_back(sample);
}

void OdometryFrontEnd::add(ScanSample sample) {
  EXPECTS(in_order(scans_, sample));
  scans_.push_back(std::move(sample));
}

void OdometryFrontEnd::flush() {
  flushed_ = true;
  settle();
  if (!wheels_.empty() && wheels_reach(wheels_.back().stamp) && wheels_.back().stamp > track_.end()) {
    add_wheel_motion(wheels_.back().stamp);
  }
  if (!scans_.empty() && track_.empty()) {
    throw InputError("there are scans, but no two pictures or wheel samples to tell how the base moved between them");
  }
}

std::optional<Reading> OdometryFrontEnd::next() {
  if (scans_.empty() || track_.empty()) return std::nullopt;
  if (!flushed_ && track_.end() < middle_of(scans_.front())) return std::nullopt;
  ScanSample sample = std::move(scans_.front());
  scans_.pop_front();
  return reading_of(std::move(sample));
}

void OdometryFrontEnd::start_at(Time stamp) {
  if (!std::exchange(started_, true)) track_.start(stamp);
}

/// Moves spans into the track, in their order, as far as the wheels reach where they are needed.
void OdometryFrontEnd::settle() {
  while (!spans_.empty()) {
    const Span& span = spans_.front();
    if (span.visual) {
      track_.add(*span.visual, span.end);
    } else if (!geometry_) {
      throw InputError("the floor camera gives no motion before " + std::to_string(span.end.seconds()) +
                       " s, and there are no wheel encoders to fall back on");
    } else if (wheels_reach(span.end)) {
      add_wheel_motion(span.end);
    } else {
      return;
    }
    spans_.pop_front();
  }
  while (wheels_.size() > 2 && wheels_[1].stamp <= track_.end()) wheels_.pop_front();
}

bool OdometryFrontEnd::wheels_reach(Time stamp) const {
  return wheels_.size() >= 2 && (flushed_ || wheels_.back().stamp >= stamp);
}

void OdometryFrontEnd::add_wheel_motion(Time end) {
  WheelSample before = wheels_at(track_.end());
  for (const WheelSample& sample : wheels_) {
    if (sample.stamp <= before.stamp || sample.stamp >= end) continue;
    track_.add(wheel_motion(*geometry_, config_.wheel, before, sample), sample.stamp);
    before = sample;
  }
  track_.add(wheel_motion(*geometry_, config_.wheel, before, wheels_at(end)), end);
}

WheelSample OdometryFrontEnd::wheels_at(Time stamp) const {
  const auto later = std::find_if(wheels_.begin() + 1, wheels_.end() - 1,
                                  [&](const WheelSample& sample) { return stamp <= sample.stamp; });
  return interpolate(*(later - 1), *later, stamp);
}

Reading OdometryFrontEnd::reading_of(ScanSample sample) {
  Reading reading{.sequence = sequence_, .stamp = sample.stamp};
  if (sequence_ > 0) reading.motion = track_.between(last_reading_, sample.stamp);
  reading.twist = track_.twist_at(middle_of(sample));
  reading.heading = heading_at(sample.stamp);
  if (!sample.scan.ranges.empty()) reading.scan = std::move(sample.scan);
  last_reading_ = reading.stamp;
  ++sequence_;
  track_.forget_before(last_reading_);
  return reading;
}

/// The latest heading since the reading before, turned on by odometry; uses up all that are older.
std::optional<double> OdometryFrontEnd::heading_at(Time stamp) {
  std::optional<CompassSample> latest;
  while (!compass_.empty() && compass_.front().stamp <= stamp) {
    latest = compass_.front();
    compass_.pop_front();
  }
  if (!latest || (sequence_ > 0 && latest->stamp <= last_reading_)) return std::nullopt;
  return wrap_angle(latest->heading + track_.between(latest->stamp, stamp).T_before_now.theta);
}

}  // namespace cogslam
