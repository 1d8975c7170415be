#include "sensors/camera_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/rng.hpp"

namespace cogslam {
namespace {

TEST(CameraModel, SeesTheStatedFieldOfView) {
  const CameraModel camera{.width = 320, .field_of_view = std::numbers::pi / 3.0, .height_above_floor = 0.3};
  EXPECT_NEAR(camera.metres_per_pixel(), 2.0 * 0.3 / std::sqrt(3.0) / 320.0, 1e-12);
}

TEST(CameraModel, LooksForwardAtTheTopAndLeftAtTheLeft) {
  const CameraModel camera;
  EXPECT_NEAR((camera.floor_point({160.0, 120.0}) - Eigen::Vector2d(0.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_GT(camera.floor_point({160.0, 0.0}).x(), 0.1);
  EXPECT_GT(camera.floor_point({0.0, 120.0}).y(), 0.1);
}

TEST(CameraModel, MountingMovesAndTurnsTheView) {
  CameraModel camera;
  camera.T_base_camera = {0.2, 0.1, std::numbers::pi / 2.0};  // the picture's top points left
  EXPECT_NEAR((camera.floor_point({160.0, 120.0}) - Eigen::Vector2d(0.2, 0.1)).norm(), 0.0, 1e-12);
  EXPECT_GT(camera.floor_point({160.0, 0.0}).y(), 0.2);
}

TEST(CameraModel, PixelAndFloorPointAreInverse) {
  Rng rng({.seed = 3, .purpose = Purpose::kWorld});
  for (int i = 0; i < 100; ++i) {
    CameraModel camera{.height_above_floor = rng.uniform(0.1, 1.0)};
    camera.T_base_camera = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-3.0, 3.0)};
    const Eigen::Vector2d pixel(rng.uniform(0.0, 320.0), rng.uniform(0.0, 240.0));
    EXPECT_NEAR((camera.pixel_of(camera.floor_point(pixel)) - pixel).norm(), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace cogslam
