#include "sim/wheel_motor.hpp"

#include <gtest/gtest.h>

namespace cogslam {
namespace {

constexpr MotorConfig kConfig{.kp = 0.1, .ki = 1.0, .max_torque = 0.5};

TEST(WheelMotor, AnswersWithBothGains) {
  WheelMotor motor;
  EXPECT_DOUBLE_EQ(motor.torque(kConfig, 3.0, 1.0, 0.01), 0.1 * 2.0 + 1.0 * 2.0 * 0.01);
  EXPECT_DOUBLE_EQ(motor.torque(kConfig, 3.0, 1.0, 0.01), 0.1 * 2.0 + 1.0 * 2.0 * 0.02);
}

TEST(WheelMotor, KeepsToItsTorqueLimitBothWays) {
  WheelMotor motor;
  EXPECT_EQ(motor.torque(kConfig, 100.0, 0.0, 0.01), 0.5);
  EXPECT_EQ(motor.torque(kConfig, -100.0, 0.0, 0.01), -0.5);
}

TEST(WheelMotor, SavesUpNothingWhileBlocked) {
  WheelMotor motor;
  for (int i = 0; i < 10000; ++i) motor.torque(kConfig, 3.0, 0.0, 0.01);
  // Told to stop, a blocked wheel lets go at once instead of working off 300 N m.
  EXPECT_LE(motor.torque(kConfig, 0.0, 0.0, 0.01), 0.5);
  EXPECT_LT(motor.torque(kConfig, -3.0, 0.0, 0.01), 0.3);
}

}  // namespace
}  // namespace cogslam
