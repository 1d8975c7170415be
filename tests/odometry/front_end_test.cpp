#include "slam/odometry/front_end.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <vector>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "floor_drive.hpp"

namespace cogslam {
namespace {

const Twist2 kTwist{0.25, 0.1, 0.3};
const MecanumGeometry kGeometry;

Pose2 truth_at(Time stamp) { return Pose2::exp(stamp.seconds() * kTwist); }

WheelSample wheels_at(Time stamp) {
  WheelSample sample{.stamp = stamp};
  const WheelSpeeds speeds = wheel_speeds(kGeometry, kTwist);
  for (std::size_t i = 0; i < 4; ++i) sample.angles[i] = stamp.seconds() * speeds[i];
  return sample;
}

ScanSample scan_at(Time stamp) {
  Scan scan;
  scan.time_increment = Duration::from_seconds(0.00001);
  scan.ranges.assign(1001, 1.0F);  // a sweep of 10 ms
  return {stamp, scan};
}

struct Feed {
  bool pictures = false;
  bool wheels = false;
  bool compass = false;
  FloorCameraConfig camera{};
  FloorKind floor = FloorKind::kCarpet;
};

/// A second of driving at a constant twist: pictures at 30 Hz, wheels at 100 Hz, compass at 50 Hz, scans at 40 Hz.
std::vector<Reading> run(OdometryFrontEnd& front_end, const Feed& feed) {
  std::optional<FloorCamera> camera;
  if (feed.pictures) camera.emplace(feed.camera, Floor{.kind = feed.floor}, 1U);
  std::vector<Reading> readings;
  std::uint64_t frame = 0;
  for (int ms = 0; ms <= 1000; ms += 5) {
    const Time now{ms * std::int64_t{1'000'000}};
    while (feed.pictures && frame_stamp(frame) <= now) {
      const Time stamp = frame_stamp(frame);
      front_end.add(camera->capture(frame++, stamp, truth_at(stamp), kTwist));
    }
    if (feed.wheels && ms % 10 == 0) front_end.add(wheels_at(now));
    if (feed.compass && ms % 20 == 0) front_end.add(CompassSample{now, truth_at(now).theta});
    if (ms % 25 == 0) front_end.add(scan_at(now));
    while (auto reading = front_end.next()) readings.push_back(*reading);
  }
  front_end.flush();
  while (auto reading = front_end.next()) readings.push_back(*reading);
  return readings;
}

void expect_true_motion(const std::vector<Reading>& readings, double position, double turn) {
  ASSERT_EQ(readings.size(), 41U);
  EXPECT_EQ(readings[0].motion.T_before_now, Pose2{});
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(readings[i].sequence, i);
    EXPECT_EQ(readings[i].stamp.ns, static_cast<std::int64_t>(i) * 25'000'000);
    ASSERT_TRUE(readings[i].scan);
    EXPECT_NEAR(readings[i].twist.x, kTwist.x, 30.0 * position);
    if (i == 0) continue;
    const Pose2 expected = truth_at(readings[i - 1].stamp).inverse() * truth_at(readings[i].stamp);
    const Twist2 error = (readings[i].motion.T_before_now.inverse() * expected).log();
    EXPECT_NEAR(error.x, 0.0, position) << i;
    EXPECT_NEAR(error.y, 0.0, position) << i;
    EXPECT_NEAR(error.theta, 0.0, turn) << i;
    EXPECT_GT(readings[i].motion.covariance(0, 0), 0.0);
  }
}

TEST(OdometryFrontEnd, SharesOutTheMotionBetweenPictures) {
  OdometryFrontEnd front_end({}, CameraModel{}, std::nullopt);
  const auto readings = run(front_end, {.pictures = true});
  expect_true_motion(readings, 0.0002, radians(0.1));
  for (const Reading& reading : readings) EXPECT_EQ(reading.motion.source, MotionSource::kVisual);
  EXPECT_EQ(front_end.spans(), 30U);
  EXPECT_EQ(front_end.spans_without_estimate(), 0U);
}

TEST(OdometryFrontEnd, UsesTheWheelsWhereTheCameraIsBlind) {
  Feed feed{.pictures = true, .wheels = true};
  feed.camera.blackouts = {{0.4, 0.6}};
  OdometryFrontEnd front_end({}, CameraModel{}, kGeometry);
  const auto readings = run(front_end, feed);
  expect_true_motion(readings, 0.0002, radians(0.1));
  for (const Reading& reading : readings) {
    const double t = reading.stamp.seconds();
    const bool blind = t > 0.43 && t < 0.59, sees = t < 0.36 || (t > 0.67 && t < 0.99);
    EXPECT_TRUE(!blind || reading.motion.source == MotionSource::kWheel) << t;
    EXPECT_TRUE(!sees || reading.motion.source == MotionSource::kVisual) << t;
  }
  EXPECT_EQ(front_end.spans_without_estimate(), 7U);  // pictures 12 to 17 are dark
}

TEST(OdometryFrontEnd, DrivesOnWheelsAlone) {
  for (const auto source : {OdometrySource::kVisual, OdometrySource::kWheel}) {
    OdometryFrontEnd front_end({.source = source}, std::nullopt, kGeometry);
    const auto readings = run(front_end, {.wheels = true});
    expect_true_motion(readings, 1e-9, 1e-9);
    EXPECT_EQ(readings[5].motion.source, MotionSource::kWheel);
  }
}

TEST(OdometryFrontEnd, SourceWheelIgnoresPictures) {
  OdometryFrontEnd front_end({.source = OdometrySource::kWheel}, CameraModel{}, kGeometry);
  expect_true_motion(run(front_end, {.pictures = true, .wheels = true}), 1e-9, 1e-9);
  EXPECT_EQ(front_end.spans(), 0U);
}

TEST(OdometryFrontEnd, CarriesTheHeadingToTheScan) {
  OdometryFrontEnd front_end({}, std::nullopt, kGeometry);
  const auto readings = run(front_end, {.wheels = true, .compass = true});
  for (const Reading& reading : readings) {
    ASSERT_TRUE(reading.heading);
    EXPECT_NEAR(*reading.heading, truth_at(reading.stamp).theta, 1e-9);
  }
}

TEST(OdometryFrontEnd, HasNoHeadingWithoutAFreshSample) {
  OdometryFrontEnd front_end({}, std::nullopt, kGeometry);
  front_end.add(CompassSample{Time{}, 0.5});
  const auto readings = run(front_end, {.wheels = true});
  EXPECT_TRUE(readings[0].heading);
  EXPECT_FALSE(readings[1].heading);
}

TEST(OdometryFrontEnd, CovariancesOfReadingsAddUpToThoseOfTheWay) {
  // However many scans cut the way, the variance of a straight way is that of its length.
  OdometryFrontEnd front_end({}, std::nullopt, kGeometry);
  double turn_variance = 0.0;
  for (const Reading& reading : run(front_end, {.wheels = true})) turn_variance += reading.motion.covariance(2, 2);
  const WheelOdometryConfig wheel;
  const double way = std::hypot(kTwist.x, kTwist.y);
  const double expected = std::pow(wheel.turn_noise_per_sqrt_metre, 2) * way +
                          std::pow(wheel.turn_noise_per_sqrt_radian, 2) * kTwist.theta +
                          100.0 * std::pow(wheel.noise_floor, 2);
  EXPECT_NEAR(turn_variance, expected, 0.01 * expected);
}

TEST(OdometryFrontEnd, RefusesToGuess) {
  const auto message = [](const std::function<void()>& action) -> std::string {
    try {
      action();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message([] { OdometryFrontEnd({}, std::nullopt, std::nullopt); }),
            "odometry has nothing to work with, expected a floor camera, wheel encoders or both");
  EXPECT_EQ(message([] { OdometryFrontEnd({.source = OdometrySource::kWheel}, CameraModel{}, std::nullopt); }),
            "odometry source is `wheel`, but there are no wheel encoders");
  EXPECT_THAT(message([] {
                OdometryFrontEnd front_end({}, CameraModel{}, std::nullopt);
                run(front_end, {.pictures = true, .floor = FloorKind::kPlain});
              }),
              testing::HasSubstr("and there are no wheel encoders to fall back on"));
  EXPECT_EQ(message([] {
              OdometryFrontEnd front_end({}, std::nullopt, kGeometry);
              run(front_end, {});
            }),
            "there are scans, but no two pictures or wheel samples to tell how the base moved between them");
}

TEST(OdometryConfig, ReadsItsSectionAndNamesWhatIsWrong) {
  OdometryConfig config;
  ConfigSection good =
      ConfigSection::parse("source: wheel\nvisual: {points: 50}\nwheel: {noise_floor: 0.001}\n", "a.yaml");
  read(good, config);
  good.finish();
  EXPECT_EQ(config.source, OdometrySource::kWheel);
  EXPECT_EQ(config.visual.flow.points, 50);
  ConfigSection bad = ConfigSection::parse("visual: {points: 15}\n", "b.yaml");
  EXPECT_THROW(read(bad, config), InputError);
}

TEST(OdometryFrontEnd, ASweepWithoutRangesBecomesAReadingWithoutAScan) {
  OdometryFrontEnd front_end({}, std::nullopt, kGeometry);
  for (int ms = 0; ms <= 100; ms += 10) {
    const Time now{ms * std::int64_t{1'000'000}};
    front_end.add(wheels_at(now));
    if (ms % 20 == 0) front_end.add(ms == 40 ? ScanSample{.stamp = now, .scan = {}} : scan_at(now));
  }
  front_end.flush();
  std::vector<Reading> readings;
  while (auto reading = front_end.next()) readings.push_back(*reading);
  ASSERT_EQ(readings.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(readings[i].scan.has_value(), i != 2) << i;
  EXPECT_GT(readings[2].motion.T_before_now.position().norm(), 0.004) << "motion goes on";
}

TEST(OdometryFrontEnd, WheelsStandInWhileTheCameraIsFrozenAndNoMotionIsToldTwice) {
  FloorCamera camera({}, Floor{}, 1U);
  OdometryFrontEnd front_end({}, CameraModel{}, kGeometry);
  std::vector<Reading> readings;
  FloorImage stuck;
  for (int ms = 0; ms <= 1000; ms += 10) {
    const Time now{ms * std::int64_t{1'000'000}};
    front_end.add(wheels_at(now));
    if (ms % 40 == 0) {
      const bool frozen = ms > 300 && ms < 700;
      FloorImage image = camera.capture(static_cast<std::uint64_t>(ms), now, truth_at(now), kTwist);
      if (!frozen) stuck = image;
      front_end.add(FloorImage{now, image.width, image.height, stuck.grey});
      front_end.add(scan_at(now));
    }
    while (auto reading = front_end.next()) readings.push_back(*reading);
  }
  front_end.flush();
  while (auto reading = front_end.next()) readings.push_back(*reading);
  EXPECT_EQ(front_end.pictures_repeated(), 10U);
  EXPECT_EQ(front_end.spans_without_estimate(), 11U) << "and the one to the first picture after them";
  Pose2 T_start_now;
  for (const Reading& reading : readings) T_start_now = T_start_now * reading.motion.T_before_now;
  const Pose2 truth = truth_at(readings.back().stamp);
  EXPECT_LT((T_start_now.position() - truth.position()).norm(), 0.005);
  EXPECT_NEAR(T_start_now.theta, truth.theta, 0.01);
}

}  // namespace
}  // namespace cogslam
