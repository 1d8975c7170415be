#include "sensors/wheel_encoder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace cogslam {
namespace {

TEST(WheelEncoder, CountsWholeTicksNearestToTheAngle) {
  const WheelEncoderConfig config{50.0, 360};
  Truth truth;
  truth.time = {20'000'000};
  truth.wheel_angles = {0.0, 10.4 * std::numbers::pi / 180, -10.6 * std::numbers::pi / 180, 1000.0};
  const WheelSample sample = encode_wheels(config, truth);
  EXPECT_EQ(sample.stamp, truth.time);
  EXPECT_NEAR(sample.angles[0], 0.0, 1e-15);
  EXPECT_NEAR(sample.angles[1] * 180 / std::numbers::pi, 10.0, 1e-9);
  EXPECT_NEAR(sample.angles[2] * 180 / std::numbers::pi, -11.0, 1e-9);
  const double tick = 2 * std::numbers::pi / 360;
  EXPECT_LE(std::abs(sample.angles[3] - 1000.0), 0.5 * tick + 1e-12);
  EXPECT_NEAR(sample.angles[3] / tick, std::round(sample.angles[3] / tick), 1e-9);
}

TEST(WheelEncoder, DoesNotFlickerAtRest) {
  Truth truth;
  truth.wheel_angles = {1e-9, -1e-9, 1e-12, -1e-12};
  for (const double angle : encode_wheels(WheelEncoderConfig{}, truth).angles) EXPECT_EQ(angle, 0.0);
}

TEST(WheelEncoder, ReadsItsTicks) {
  ConfigSection s = ConfigSection::parse("ticks_per_turn: 210\nrate_hz: 100\n", "w.yaml");
  const WheelEncoderConfig c = read_wheel_encoder_config(s);
  s.finish();
  EXPECT_EQ(c.ticks_per_turn, 210);
  EXPECT_EQ(c.rate_hz, 100.0);
}

}  // namespace
}  // namespace cogslam
