#include "sensors/lidar.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/support/statistics.hpp"
#include "tests/support/test_worlds.hpp"

namespace cogslam {
namespace {

/// Truth every millisecond for half a second, moving by a constant twist from `start`.
PoseTrack moving(const Pose2& start, const Twist2& twist) {
  PoseTrack track({500'000'000});
  for (int ms = 0; ms <= 500; ++ms) {
    Truth t;
    t.time = {ms * 1'000'000};
    t.T_map_base = start * Pose2::exp(0.001 * ms * twist);
    t.twist = twist;
    track.push(t);
  }
  return track;
}

LidarConfig noiseless() {
  LidarConfig c;
  c.sigma_near_m = c.sigma_far_m = c.resolution_m = c.dropout_probability = 0.0;
  return c;
}

/// Distance from `p` to the wall of a square room around the origin, along `angle`.
double to_square_wall(double side, const Eigen::Vector2d& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), half = 0.5 * side;
  const double x = c > 0 ? (half - p.x()) / c : (-half - p.x()) / c;
  const double y = s > 0 ? (half - p.y()) / s : (-half - p.y()) / s;
  return std::min(std::abs(x), std::abs(y));
}

/// Errors of `scans` scans of a round room, one row per scan: every beam has the same true range.
std::vector<std::vector<double>> errors_at(double radius, LidarConfig config, int scans, std::uint32_t seed = 5) {
  config.dropout_probability = 0.0;
  config.resolution_m = 0.0;
  World world;
  world.walls.emplace_back();
  for (int i = 0; i < 7200; ++i)
    world.walls[0].emplace_back(radius * std::cos(i * std::numbers::pi / 3600),
                                radius * std::sin(i * std::numbers::pi / 3600));
  const Lidar lidar(config, world, seed);
  const PoseTrack track = moving({}, {});
  std::vector<std::vector<double>> errors;
  for (int n = 0; n < scans; ++n) {
    errors.emplace_back();
    for (const float r : lidar.sweep(track, {}, static_cast<std::uint64_t>(n)).scan.ranges)
      errors.back().push_back(static_cast<double>(r) - radius);
  }
  return errors;
}

TEST(Lidar, PresetsAreTheDataSheets) {
  const LidarConfig utm = LidarConfig::utm30lx(), lms = LidarConfig::lms200();
  EXPECT_EQ(utm.beams, 1081);
  EXPECT_NEAR(degrees(utm.field_of_view), 270.0, 1e-9);
  EXPECT_NEAR(degrees(utm.angle_increment()), 0.25, 1e-9);
  EXPECT_EQ(utm.rate_hz, 40.0);
  EXPECT_EQ(utm.range_min_m, 0.1);
  EXPECT_EQ(utm.range_max_m, 30.0);
  EXPECT_EQ(utm.accuracy_near_m, 0.030);
  EXPECT_EQ(utm.accuracy_far_m, 0.050);
  EXPECT_EQ(utm.near_limit_m, 10.0);
  EXPECT_EQ(lms.beams, 181);
  EXPECT_NEAR(degrees(lms.angle_increment()), 1.0, 1e-9);
  EXPECT_EQ(lms.range_max_m, 8.0);
  EXPECT_EQ(lms.resolution_m, 0.010);
  EXPECT_EQ(utm.check(), "");
  EXPECT_EQ(lms.check(), "");
  EXPECT_NEAR(Lidar(utm, square_room(4.0), 1).sweep_time().seconds(), 0.01875, 1e-6);
  EXPECT_NEAR(Lidar(lms, square_room(4.0), 1).sweep_time().seconds(), 0.5 / 75.0, 1e-6);
}

TEST(Lidar, ReadsAPresetAndChangesToIt) {
  ConfigSection s =
      ConfigSection::parse("preset: lms200\nrange_max_m: 20\nmount_m: [0.1, -0.2]\nmount_yaw_deg: 90\n", "l.yaml");
  const LidarConfig c = read_lidar_config(s);
  s.finish();
  EXPECT_EQ(c.beams, 181);
  EXPECT_EQ(c.range_max_m, 20.0);
  EXPECT_EQ(c.T_base_lidar, (Pose2{0.1, -0.2, radians(90.0)}));
}

TEST(Lidar, RejectsASweepLongerThanItsPeriod) {
  ConfigSection s = ConfigSection::parse("rate_hz: 60\n", "l.yaml");
  try {
    read_lidar_config(s);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr(
                              "a sweep takes longer than 1 / rate_hz, expected a lower rate_hz or a higher mirror_hz"));
  }
}

TEST(Lidar, SeesTheRoomExactlyWithoutNoise) {
  LidarConfig config = noiseless();
  config.T_base_lidar = {0.2, -0.1, 0.7};
  const Pose2 T_map_base{0.4, 0.3, -1.1};
  const Scan scan = Lidar(config, square_room(4.0), 1).sweep(moving(T_map_base, {}), {3'000'000}, 0).scan;
  const Pose2 T_map_lidar = T_map_base * config.T_base_lidar;
  ASSERT_EQ(scan.ranges.size(), 1081u);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.angle_first + static_cast<double>(i) * scan.angle_increment + T_map_lidar.theta;
    EXPECT_NEAR(scan.ranges[i], to_square_wall(4.0, T_map_lidar.position(), angle), 1e-6) << "beam " << i;
  }
  EXPECT_EQ(scan.T_base_lidar, config.T_base_lidar);
}

TEST(Lidar, CastsEachBeamFromThePoseAtItsOwnTime) {
  LidarConfig config = noiseless();
  config.T_base_lidar = {0.15, 0.05, 0.1};
  const Pose2 start{0.2, -0.1, 2.0};
  const Twist2 twist{0.4, -0.2, 1.5};
  const Time first{137'300'000};  // between two steps
  const ScanSample sample = Lidar(config, square_room(6.0), 1).sweep(moving(start, twist), first, 0);
  double bent = 0.0;
  for (std::size_t i = 0; i < sample.scan.ranges.size(); ++i) {
    const Time at = first + static_cast<std::int64_t>(i) * sample.scan.time_increment;
    const double beam = sample.scan.angle_first + static_cast<double>(i) * sample.scan.angle_increment;
    const Pose2 T_map_lidar = start * Pose2::exp(at.seconds() * twist) * config.T_base_lidar;
    const Pose2 T_map_frozen = start * Pose2::exp(first.seconds() * twist) * config.T_base_lidar;
    const double expected = to_square_wall(6.0, T_map_lidar.position(), T_map_lidar.theta + beam);
    EXPECT_NEAR(sample.scan.ranges[i], expected, 5e-6) << "beam " << i;
    bent = std::max(bent, std::abs(expected - to_square_wall(6.0, T_map_frozen.position(), T_map_frozen.theta + beam)));
  }
  EXPECT_GT(bent, 0.05) << "the sweep must be bent enough to tell";
}

TEST(Lidar, TellsNoReturnFromTooClose) {
  LidarConfig config = noiseless();
  config.range_max_m = 2.5;
  const Scan scan = Lidar(config, square_room(4.0), 1).sweep(moving({1.95, 0.0, 0.0}, {}), {}, 0).scan;
  EXPECT_EQ(scan.ranges[540], Scan::kTooClose);    // 0.05 m ahead
  EXPECT_EQ(scan.ranges[0], Scan::kNoReturn);      // backwards and to the right: 2.83 m
  EXPECT_NEAR(scan.ranges[540 - 360], 2.0, 1e-6);  // to the right
}

TEST(Lidar, KeepsFiniteReadingsWithinItsRange) {
  LidarConfig config;
  config.range_max_m = 3.0;
  const Scan scan = Lidar(config, square_room(5.999), 1).sweep(moving({}, {}), {}, 0).scan;
  int finite = 0, none = 0;
  for (const float r : scan.ranges) {
    EXPECT_TRUE(r == Scan::kNoReturn || (r >= 0.1F && r <= 3.0F)) << r;
    (std::isfinite(r) ? finite : none)++;
  }
  EXPECT_GT(finite, 10);
  EXPECT_GT(none, 900);
}

TEST(Lidar, NoiseHasTheStatedSpreadAndBounds) {
  for (const auto& [radius, sigma, bound] : {std::tuple{5.0, 0.010, 0.030}, std::tuple{15.0, 0.0167, 0.050}}) {
    const Moments m = moments(flatten(errors_at(radius, LidarConfig{}, 100)));
    // Five standard errors of the mean and of the variance of 108 100 draws; clipping at 3 sigma takes 0.5 %.
    EXPECT_NEAR(m.mean, 0.0, 5.0 * sigma / std::sqrt(m.count)) << radius;
    EXPECT_NEAR(m.variance / (sigma * sigma), 0.995, 5.0 * std::sqrt(2.0 / m.count)) << radius;
    EXPECT_LE(m.max, bound + 2e-6);
    EXPECT_GE(m.min, -bound - 2e-6);
    EXPECT_GT(m.max, 0.98 * bound);
  }
}

TEST(Lidar, NoiseIsIndependentBetweenBeamsAndScans) {
  const auto errors = errors_at(5.0, LidarConfig{}, 100);
  std::vector<double> this_beam, next_beam, this_scan, next_scan;
  for (std::size_t n = 0; n + 1 < errors.size(); ++n)
    for (std::size_t i = 0; i + 1 < errors[n].size(); ++i) {
      this_beam.push_back(errors[n][i]);
      next_beam.push_back(errors[n][i + 1]);
      next_scan.push_back(errors[n + 1][i]);
    }
  const double five_sigma = 5.0 / std::sqrt(static_cast<double>(this_beam.size()));
  EXPECT_LT(std::abs(correlation(this_beam, next_beam)), five_sigma);
  EXPECT_LT(std::abs(correlation(this_beam, next_scan)), five_sigma);
  EXPECT_LT(std::abs(correlation(errors[0], errors_at(5.0, LidarConfig{}, 1, 6)[0])), 5.0 / std::sqrt(1081.0));
}

TEST(Lidar, DrawsTheSameInAnyOrder) {
  const Lidar lidar(LidarConfig{}, square_room(4.0), 9);
  const PoseTrack track = moving({}, {0.1, 0.0, 0.2});
  const Scan a = lidar.sweep(track, {0}, 0).scan, b = lidar.sweep(track, {25'000'000}, 1).scan;
  const Lidar again(LidarConfig{}, square_room(4.0), 9);
  EXPECT_EQ(again.sweep(track, {25'000'000}, 1).scan, b);
  EXPECT_EQ(again.sweep(track, {0}, 0).scan, a);
}

TEST(Lidar, WhatOneBeamMeetsLeavesTheNoiseOfTheOthersAlone) {
  World world = square_room(4.0);
  const PoseTrack track = moving({}, {});
  const Scan without = Lidar(LidarConfig{}, world, 3).sweep(track, {}, 0).scan;
  world.obstacles = {rectangle({0.01, -0.5}, {0.05, 0.5})};  // straight ahead, too close
  const Scan with = Lidar(LidarConfig{}, world, 3).sweep(track, {}, 0).scan;
  EXPECT_EQ(with.ranges[540], Scan::kTooClose);
  EXPECT_EQ(with.ranges[0], without.ranges[0]);
  EXPECT_EQ(with.ranges[1080], without.ranges[1080]);
}

TEST(Lidar, LosesTheStatedShareOfEchoes) {
  LidarConfig config;
  config.dropout_probability = 0.02;
  const Lidar lidar(config, square_room(4.0), 2);
  const PoseTrack track = moving({}, {});
  double lost = 0, all = 0;
  for (std::uint64_t n = 0; n < 100; ++n)
    for (const float r : lidar.sweep(track, {}, n).scan.ranges) {
      lost += r == Scan::kNoReturn;
      all += 1;
    }
  EXPECT_NEAR(lost / all, 0.02, 5.0 * std::sqrt(0.02 * 0.98 / all));
}

TEST(Lidar, RoundsToItsResolution) {
  LidarConfig config = LidarConfig::lms200();
  config.dropout_probability = 0.0;
  for (const float r : Lidar(config, square_room(4.0), 2).sweep(moving({}, {}), {}, 0).scan.ranges)
    EXPECT_NEAR(100.0 * static_cast<double>(r), std::round(100.0 * static_cast<double>(r)), 1e-4);
}

}  // namespace
}  // namespace cogslam
