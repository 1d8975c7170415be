#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/config.hpp"
#include "core/pose2.hpp"
#include "sensors/camera_model.hpp"
#include "sensors/floor_light.hpp"
#include "sensors/readings.hpp"
#include "worlds/world.hpp"

namespace cogslam {

class FloorRenderer;

/// The camera under the robot, and all that spoils its pictures.
struct FloorCameraConfig {
  bool enabled = true;
  CameraModel model{};        ///< as calibrated: what odometry is told
  double height_error = 0.0;  ///< true height above the floor less the calibrated, as a share of it
  double yaw_error = 0.0;     ///< true mounting angle less the calibrated [rad]
  double rate = 30.0;         ///< [Hz]
  double noise = 3.0;         ///< of each pixel, standard deviation [grey]
  double exposure = 0.0;      ///< [s]; over 0: pictures are smeared along the motion
  int exposure_steps = 6;     ///< pictures averaged over the exposure
  FloorLightConfig light{};
  std::vector<Eigen::Vector2d> blackouts;  ///< spans (from, to) [s] without any light; noise remains
};

/// Reads the `camera:` section.
void read(ConfigSection& section, FloorCameraConfig& config);

/// The camera as it really hangs: `config.model` with its calibration errors.
CameraModel true_model(const FloorCameraConfig& config);

/// Takes pictures of a floor. A picture is a function of (configuration, floor, seed, frame, stamp, pose, twist) alone.
class FloorCamera {
 public:
  /// Paints the floor (about 0.1 s) and loads libOSMesa (about 0.3 s, once per program). Throws InputError where it
  /// cannot be loaded.
  FloorCamera(const FloorCameraConfig& config, const Floor& floor, std::uint32_t seed);
  ~FloorCamera();

  /// The picture of frame number `frame`, taken at `stamp` (the middle of the exposure) from a base that stands at
  /// `T_map_base` and moves with `twist`. The twist matters only where the exposure is over 0.
  FloorImage capture(std::uint64_t frame, Time stamp, const Pose2& T_map_base, const Twist2& twist);

 private:
  void expose(const Pose2& T_map_base, const Twist2& twist, std::vector<std::uint8_t>& grey);
  void render(const Pose2& T_map_base, std::vector<std::uint8_t>& grey);
  [[nodiscard]] bool blacked_out(Time stamp) const;

  FloorCameraConfig config_;
  CameraModel true_model_;
  std::uint32_t seed_;
  std::vector<float> vignette_;
  std::unique_ptr<FloorRenderer> renderer_;
};

}  // namespace cogslam
