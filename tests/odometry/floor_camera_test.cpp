#include "sensors/floor_camera.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "core/rng.hpp"
#include "floor_drive.hpp"
#include "sensors/floor_light.hpp"
#include "sensors/pixel_noise.hpp"
#include "worlds/floor_texture.hpp"

namespace cogslam {
namespace {

/// Bilinear sample of a texture level whose side is `size` texels, at texture coordinates in [0, 1) per period.
double sample_level(const std::vector<double>& level, int size, double s, double t) {
  const double u = s * size - 0.5, v = t * size - 0.5;
  const double i = std::floor(u), j = std::floor(v);
  const auto at = [&](double column, double row) {
    const int c = (static_cast<int>(column) % size + size) % size, r = (static_cast<int>(row) % size + size) % size;
    return level[static_cast<std::size_t>(r) * static_cast<std::size_t>(size) + static_cast<std::size_t>(c)];
  };
  const double a = u - i, b = v - j;
  return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) + b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
}

/// The picture by the book: tri-linear between the texture and its first mip level (means of 2 x 2 texels).
class SlowFloor {
 public:
  explicit SlowFloor(const FloorTexture& texture)
      : full_(texture.grey.begin(), texture.grey.end()), half_(full_.size() / 4) {
    constexpr int kHalf = FloorTexture::kSize / 2;
    for (int row = 0; row < kHalf; ++row) {
      for (int column = 0; column < kHalf; ++column) {
        const int c = 2 * column, r = 2 * row;
        half_[static_cast<std::size_t>(row * kHalf + column)] =
            0.25 * (texture.at(c, r) + texture.at(c + 1, r) + texture.at(c, r + 1) + texture.at(c + 1, r + 1));
      }
    }
  }
  [[nodiscard]] double grey(const Eigen::Vector2d& p_map, double metres_per_pixel) const {
    const double s = p_map.x() / FloorTexture::kPeriod, t = p_map.y() / FloorTexture::kPeriod;
    const double level = std::clamp(std::log2(metres_per_pixel / FloorTexture::kTexel), 0.0, 1.0);
    return (1.0 - level) * sample_level(full_, FloorTexture::kSize, s, t) +
           level * sample_level(half_, FloorTexture::kSize / 2, s, t);
  }

 private:
  std::vector<double> full_, half_;
};

TEST(FloorCamera, DrawsWhatTheTextureHolds) {
  Rng rng({.seed = 11, .purpose = Purpose::kWorld});
  for (const FloorKind kind : {FloorKind::kCarpet, FloorKind::kTile}) {
    const Floor floor{.kind = kind, .seed = 3};
    const SlowFloor slow(paint_floor(floor));
    FloorCameraConfig config = clean_camera();
    config.model.T_base_camera = {0.1, -0.05, 0.2};
    FloorCamera camera(config, floor, 1);
    for (int i = 0; i < 4; ++i) {
      const Pose2 T_map_base{rng.uniform(-20.0, 20.0), rng.uniform(-20.0, 20.0), rng.uniform(-3.1, 3.1)};
      const FloorImage image = camera.capture(0, Time{}, T_map_base, Twist2{});
      double worst = 0.0, mean = 0.0;
      for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
          const Eigen::Vector2d p_map = T_map_base * config.model.floor_point({column + 0.5, row + 0.5});
          const double expected = slow.grey(p_map, config.model.metres_per_pixel());
          const double error = std::abs(image.grey[static_cast<std::size_t>(row * image.width + column)] - expected);
          worst = std::max(worst, error);
          mean += error / static_cast<double>(image.grey.size());
        }
      }
      EXPECT_LT(worst, 5.0);
      EXPECT_LT(mean, 1.0);
    }
  }
}

/// Root mean square difference between `after` and `before` shifted by whole pixels.
double shifted_difference(const FloorImage& before, const FloorImage& after, int right, int down) {
  double sum = 0.0, count = 0.0;
  for (int row = 30; row < before.height - 30; ++row) {
    for (int column = 30; column < before.width - 30; ++column, ++count) {
      const double d = after.grey[static_cast<std::size_t>((row + down) * after.width + column + right)] -
                       before.grey[static_cast<std::size_t>(row * before.width + column)];
      sum += d * d;
    }
  }
  return std::sqrt(sum / count);
}

TEST(FloorCamera, FloorMovesBackWhenTheRobotMovesForward) {
  FloorCamera camera(clean_camera(), Floor{}, 1);
  const double pixel = CameraModel{}.metres_per_pixel();
  const FloorImage here = camera.capture(0, Time{}, Pose2{1.0, 1.0, 0.7}, Twist2{});
  const FloorImage forward = camera.capture(0, Time{}, Pose2{1.0, 1.0, 0.7} * Pose2{8.0 * pixel, 0.0, 0.0}, Twist2{});
  const FloorImage left = camera.capture(0, Time{}, Pose2{1.0, 1.0, 0.7} * Pose2{0.0, 8.0 * pixel, 0.0}, Twist2{});
  EXPECT_LT(shifted_difference(here, forward, 0, 8), 1.0);
  EXPECT_GT(shifted_difference(here, forward, 0, 7), 5.0);
  EXPECT_LT(shifted_difference(here, left, 8, 0), 1.0);
  EXPECT_GT(shifted_difference(here, left, 7, 0), 5.0);
}

TEST(FloorCamera, EqualCallsGiveEqualPicturesInAnyOrder) {
  FloorCameraConfig config;
  config.light.step = 0.2;
  const auto hash = [&](FloorCamera& camera, std::uint64_t frame) {
    const FloorImage image =
        camera.capture(frame, frame_stamp(frame), Pose2{0.01 * static_cast<double>(frame), 0, 0}, {});
    return Hash{}.add(std::span<const std::uint8_t>(image.grey)).value();
  };
  FloorCamera first(config, Floor{}, 9), second(config, Floor{}, 9), other_seed(config, Floor{}, 10);
  const auto a = hash(first, 4), b = hash(first, 5);
  EXPECT_EQ(hash(second, 5), b);
  EXPECT_EQ(hash(second, 4), a);
  EXPECT_NE(a, b);
  EXPECT_NE(hash(other_seed, 4), a);
}

TEST(FloorCamera, ExposureSmearsAlongTheMotion) {
  FloorCameraConfig config = clean_camera();
  config.exposure = 0.02;
  FloorCamera camera(config, Floor{}, 1);
  const Twist2 sideways{0.0, 0.5, 0.0};
  const auto roughness = [](const FloorImage& image, int right, int down) {
    return shifted_difference(image, image, right, down);
  };
  const FloorImage still = camera.capture(0, Time{}, Pose2{}, Twist2{});
  const FloorImage smeared = camera.capture(0, Time{}, Pose2{}, sideways);
  EXPECT_LT(roughness(smeared, 1, 0), 0.6 * roughness(still, 1, 0));
  EXPECT_GT(roughness(smeared, 0, 1), 0.6 * roughness(still, 0, 1));
}

TEST(FloorCamera, BlackoutLeavesNothingButNoise) {
  FloorCameraConfig config;
  config.blackouts = {{1.0, 2.0}};
  FloorCamera camera(config, Floor{}, 1);
  EXPECT_GT(grey_mean(camera.capture(0, Time::from_seconds(0.99), {}, {})), 50.0);
  EXPECT_LT(grey_mean(camera.capture(1, Time::from_seconds(1.0), {}, {})), 3.0);
  EXPECT_GT(grey_mean(camera.capture(2, Time::from_seconds(2.0), {}, {})), 50.0);
}

TEST(FloorCamera, CalibrationErrorsChangeTheTrueCameraOnly) {
  FloorCameraConfig config;
  config.height_error = 0.02;
  config.yaw_error = 0.01;
  EXPECT_NEAR(true_model(config).metres_per_pixel() / config.model.metres_per_pixel(), 1.02, 1e-12);
  EXPECT_NEAR(true_model(config).T_base_camera.theta, 0.01, 1e-12);
}

TEST(FloorCamera, ReadsItsSectionAndNamesWhatIsWrong) {
  FloorCameraConfig config;
  ConfigSection good = ConfigSection::parse("width_px: 640\nnoise_grey: 1.5\nblackouts_s: [[1, 2]]\n", "good.yaml");
  read(good, config);
  good.finish();
  EXPECT_EQ(config.model.width, 640);
  EXPECT_EQ(config.noise, 1.5);
  ConfigSection bad = ConfigSection::parse("blackouts_s: [[2, 1]]\n", "bad.yaml");
  try {
    read(bad, config);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("bad.yaml:1:"));
    EXPECT_THAT(error.what(), testing::HasSubstr("a blackout ends before it begins, expected [from, to]"));
  }
}

TEST(PixelNoise, IsTheSumOfFourBytesOfTheNamedStream) {
  const StreamKey key{.seed = 5, .purpose = Purpose::kCameraNoise, .entity = 0, .tick = 77};
  std::vector<std::uint8_t> grey(1000, 100);
  light_and_noise(grey, std::vector<float>(1000, 1.0F), 1.0, 10.0, key);
  Rng rng(key);
  for (const std::uint8_t value : grey) {
    const std::uint32_t word = rng.bits();
    const double sum = (word & 255U) + (word >> 8 & 255U) + (word >> 16 & 255U) + (word >> 24);
    EXPECT_NEAR(value, 100.0 + 10.0 * (sum - 510.0) / std::sqrt(65535.0 / 3.0), 0.501);
  }
}

TEST(PixelNoise, HasTheStatedDeviationAndNoMean) {
  std::vector<std::uint8_t> grey(76800, 128);
  light_and_noise(grey, std::vector<float>(grey.size(), 1.0F), 1.0, 3.0, {.seed = 2, .purpose = Purpose::kCameraNoise});
  const FloorImage image{.width = 320, .height = 240, .grey = grey};
  EXPECT_NEAR(grey_mean(image), 128.0, 5.0 * 3.0 / std::sqrt(76800.0));
  // Rounding adds 1/12; the deviation of a deviation over n draws is its 1 / sqrt(2 n).
  EXPECT_NEAR(grey_deviation(image), std::sqrt(9.0 + 1.0 / 12.0), 5.0 * 3.0 / std::sqrt(2.0 * 76800.0));
}

TEST(FloorLight, VignetteDarkensTheCornersByItsShare) {
  const std::vector<float> gains = vignette_gains({.vignette = 0.4}, 320, 240);
  EXPECT_NEAR(gains.front(), 0.6, 0.005);
  EXPECT_NEAR(gains.back(), 0.6, 0.005);
  EXPECT_NEAR(gains[120 * 320 + 160], 1.0, 0.001);
}

TEST(FloorLight, DriftIsSlowAndStepsAreSudden) {
  const FloorLightConfig drifting{.drift = 0.2, .drift_period = 5.0};
  const FloorLightConfig stepping{.drift = 0.0, .step = 0.2, .step_period = 4.0};
  double lowest = 2.0, highest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double now = light_gain(drifting, 1, frame_stamp(static_cast<std::uint64_t>(i)));
    const double next = light_gain(drifting, 1, frame_stamp(static_cast<std::uint64_t>(i) + 1));
    EXPECT_LT(std::abs(next - now), 0.4 * 1.5 / 5.0 / 30.0 + 1e-9);  // smoothstep's steepest slope is 1.5
    lowest = std::min(lowest, now), highest = std::max(highest, now);
  }
  EXPECT_LT(lowest, 0.9);
  EXPECT_GT(lowest, 0.8 - 1e-9);
  EXPECT_GT(highest, 1.1);
  EXPECT_EQ(light_gain(stepping, 1, Time::from_seconds(0.1)), light_gain(stepping, 1, Time::from_seconds(3.9)));
  EXPECT_NE(light_gain(stepping, 1, Time::from_seconds(3.9)), light_gain(stepping, 1, Time::from_seconds(4.1)));
}

}  // namespace
}  // namespace cogslam
