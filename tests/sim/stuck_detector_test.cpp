#include "sim/stuck_detector.hpp"

#include <gtest/gtest.h>

namespace cogslam {
namespace {

/// Tells the detector for `seconds` that the vehicle moves along x at `speed` while `commanded` is asked of it.
void watch(StuckDetector& detector, Truth& truth, double seconds, double speed, const Twist2& commanded) {
  for (double t = 0.0; t < seconds; t += 0.01) {
    truth.time = truth.time + Duration::from_seconds(0.01);
    truth.T_map_base.x += 0.01 * speed;
    detector.watch(truth, commanded, 0.01);
  }
}

TEST(StuckDetector, SpeaksUpAfterFiveSecondsAndTakesItBackOnceFree) {
  StuckDetector detector;
  Truth truth;
  watch(detector, truth, 4.9, 0.0, {0.3, 0.0, 0.0});
  EXPECT_FALSE(detector.stuck());
  watch(detector, truth, 0.3, 0.0, {0.3, 0.0, 0.0});
  EXPECT_TRUE(detector.stuck());
  watch(detector, truth, 0.5, 0.3, {0.3, 0.0, 0.0});
  EXPECT_FALSE(detector.stuck());
}

TEST(StuckDetector, LetsAVehicleStandThatIsToldToStand) {
  StuckDetector detector;
  Truth truth;
  watch(detector, truth, 20.0, 0.0, {0.0, 0.0, 0.0});
  EXPECT_FALSE(detector.stuck());
}

TEST(StuckDetector, AcceptsASlowVehicleThatDoesAsTold) {
  StuckDetector detector;
  Truth truth;
  watch(detector, truth, 60.0, 0.002, {0.002, 0.0, 0.0});
  EXPECT_FALSE(detector.stuck());
}

TEST(StuckDetector, NoticesAVehicleThatCannotTurn) {
  StuckDetector detector;
  Truth truth;
  watch(detector, truth, 6.0, 0.0, {0.0, 0.0, -0.5});
  EXPECT_TRUE(detector.stuck());
}

}  // namespace
}  // namespace cogslam
