#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "core/mecanum_kinematics.hpp"
#include "sensors/camera_model.hpp"
#include "sensors/readings.hpp"
#include "slam/odometry/motion_track.hpp"
#include "slam/odometry/odometry_config.hpp"

namespace cogslam {

/// Turns what the sensors say into readings, one per scan, each with the motion since the reading before.
///
/// Between two floor pictures the base is taken to move at a constant twist; a scan between them gets its share of the
/// motion and of the covariance. Where the pictures give no estimate, the wheels' motion of that span stands in
/// (MotionSource::kWheel). A reading comes out once odometry covers its sweep, so after the next picture. A picture
/// that equals the one before, pixel by pixel, is taken for that of a frozen camera and gives no estimate; a sweep
/// without ranges becomes a reading without a scan.
class OdometryFrontEnd {
 public:
  /// Throws InputError if there is neither a camera nor wheels, or if the source is `wheel` and there are no wheels.
  /// Without a camera the wheels serve alone.
  OdometryFrontEnd(const OdometryConfig& config, const std::optional<CameraModel>& camera,
                   const std::optional<MecanumGeometry>& wheels);
  ~OdometryFrontEnd();

  /// Samples of each kind come in the order of their stamps; kinds may interleave as they arrive. Throws InputError
  /// where the pictures give no estimate and there are no wheels to fall back on.
  void add(const FloorImage& image);
  void add(const WheelSample& sample);
  void add(const CompassSample& sample);
  void add(ScanSample sample);
  /// No more samples will come: the last twist carries the last scans.
  void flush();

  /// The next reading that is ready, or nothing yet.
  std::optional<Reading> next();

  /// Spans between pictures, and how many of them the camera had no estimate for.
  [[nodiscard]] std::uint64_t spans() const { return spans_seen_; }
  [[nodiscard]] std::uint64_t spans_without_estimate() const { return spans_without_; }
  /// Pictures that were equal to the one before.
  [[nodiscard]] std::uint64_t pictures_repeated() const { return pictures_repeated_; }

 private:
  /// From the end of the span before; no motion where the camera has no estimate.
  struct Span {
    Time end{};
    std::optional<MotionIncrement> visual{};
  };

  [[nodiscard]] std::optional<MotionIncrement> motion_to(const FloorImage& image);
  void start_at(Time stamp);
  void settle();
  [[nodiscard]] bool wheels_reach(Time stamp) const;
  void add_wheel_motion(Time end);
  [[nodiscard]] WheelSample wheels_at(Time stamp) const;
  [[nodiscard]] Reading reading_of(ScanSample sample);
  [[nodiscard]] std::optional<double> heading_at(Time stamp);

  OdometryConfig config_;
  std::optional<MecanumGeometry> geometry_;
  CameraModel camera_{};
  std::unique_ptr<VisualOdometry> visual_;  ///< nothing: wheels only
  std::vector<std::uint8_t> last_grey_;     ///< of the picture before
  bool started_ = false;
  bool seen_image_ = false;
  bool flushed_ = false;
  MotionTrack track_;
  std::deque<Span> spans_;  ///< not yet in the track
  std::deque<WheelSample> wheels_;
  std::deque<CompassSample> compass_;
  std::deque<ScanSample> scans_;
  std::uint64_t sequence_ = 0;
  Time last_reading_{};
  std::uint64_t spans_seen_ = 0;
  std::uint64_t spans_without_ = 0;
  std::uint64_t pictures_repeated_ = 0;
};

}  // namespace cogslam
