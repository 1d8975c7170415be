#pragma once

#include <Eigen/Core>

#include "core/pose2.hpp"

namespace cogslam {

/// A pinhole camera that looks straight down. Image x runs to the robot's right, image y to its rear, from the
/// upper-left corner; pixel centres are at half-integers.
struct CameraModel {
  int width = 320;                  ///< [pixel]
  int height = 240;                 ///< [pixel]
  double field_of_view = 1.0472;    ///< horizontal [rad]
  double height_above_floor = 0.3;  ///< [m]
  Pose2 T_base_camera{};            ///< mounting: the floor point under the lens, and which way image "up" points

  /// Side of the floor square that one pixel sees [m].
  [[nodiscard]] double metres_per_pixel() const;
  /// Floor point in the base frame [m] seen at an image point [pixel], and back.
  [[nodiscard]] Eigen::Vector2d floor_point(const Eigen::Vector2d& pixel) const;
  [[nodiscard]] Eigen::Vector2d pixel_of(const Eigen::Vector2d& p_base) const;
};

}  // namespace cogslam
