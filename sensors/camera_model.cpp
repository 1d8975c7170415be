#include "sensors/camera_model.hpp"

#include <cmath>

namespace cogslam {

double CameraModel::metres_per_pixel() const {
  return 2.0 * height_above_floor * std::tan(0.5 * field_of_view) / width;
}

Eigen::Vector2d CameraModel::floor_point(const Eigen::Vector2d& pixel) const {
  const double right = pixel.x() - 0.5 * width, rear = pixel.y() - 0.5 * height;
  return T_base_camera * Eigen::Vector2d(-rear * metres_per_pixel(), -right * metres_per_pixel());
}

Eigen::Vector2d CameraModel::pixel_of(const Eigen::Vector2d& p_base) const {
  const Eigen::Vector2d p_camera = T_base_camera.inverse() * p_base;
  return {0.5 * width - p_camera.y() / metres_per_pixel(), 0.5 * height - p_camera.x() / metres_per_pixel()};
}

}  // namespace cogslam
