#include "sensors/log/carmen_log.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "tests/sensors/damaged_files.hpp"

namespace cogslam {
namespace {

class CarmenLogFile : public testing::Test {
 protected:
  std::filesystem::path file_ = temporary_file("carmen");
  void TearDown() override { std::filesystem::remove(file_); }
  CarmenLog read(const std::string& text) {
    write_content(file_, text);
    return read_carmen_log(file_);
  }
  std::string error(const std::string& text) {
    return error_of([&] { read(text); });
  }
};

std::string flaser(const std::string& ranges, const std::string& pose, const std::string& stamp) {
  return "FLASER " + ranges + " " + pose + " " + pose + " " + stamp + " host 0.1\n";
}

TEST_F(CarmenLogFile, AppliesTheMotionOfAPairOfLinesOnce) {
  const CarmenLog log = read(
      "# a comment\n"
      "PARAM robot_frontlaser_offset 0.25 nohost 0\n"
      "PARAM robot_width 0.5 nohost 0\n"
      "ODOM 1 2 0.5 0.3 0.1 0 976052857.337530 nohost 0.0\n" +
      flaser("2 1.5 81.83", "1 2 0.5", "976052857.337530") + "RLASER 2 1 1 0 0 0 0 0 0 1 host 1\n" +
      "ODOM 2 2 0.5 0 0 0 976052858.5 nohost 0.0\n" + flaser("2 0 3", "2 3 0.5", "976052858.25"));
  ASSERT_EQ(log.readings.size(), 3u);
  EXPECT_EQ(log.scans, 2u);
  EXPECT_EQ(log.merged_lines, 1u);
  EXPECT_EQ(log.ignored_lines, 1u);
  EXPECT_EQ(log.readings[0].stamp.ns, 976052857337530000);
  EXPECT_EQ(log.readings[0].motion.T_before_now, Pose2{});
  EXPECT_EQ(log.readings[0].twist, (Twist2{0.3, 0.0, 0.1}));
  ASSERT_TRUE(log.readings[0].scan);
  EXPECT_EQ(log.readings[0].scan->ranges, (std::vector<float>{1.5F, Scan::kNoReturn}));
  EXPECT_EQ(log.readings[0].scan->T_base_lidar, (Pose2{0.25, 0.0, 0.0}));
  EXPECT_FALSE(log.readings[1].scan);
  EXPECT_NEAR(log.readings[1].motion.T_before_now.x, std::cos(0.5), 1e-12);
  EXPECT_NEAR(log.readings[1].motion.T_before_now.y, -std::sin(0.5), 1e-12);
  EXPECT_EQ(log.readings[1].motion.source, MotionSource::kLog);
  EXPECT_EQ(log.odometry[2], (Pose2{2.0, 3.0, 0.5}));
  EXPECT_LT(log.readings[2].stamp, log.readings[1].stamp) << "file order, not stamp order";
  EXPECT_TRUE(std::isnan(log.readings[2].scan->ranges[0])) << "a zero says nothing";
}

TEST_F(CarmenLogFile, SpreadsTheBeamsOver180DegreesByTheirNumber) {
  for (const auto& [beams, degrees_apart] : {std::pair{180, 1.0}, {181, 1.0}, {360, 0.5}, {361, 0.5}}) {
    std::string ranges = std::to_string(beams);
    for (int i = 0; i < beams; ++i) ranges += " 1";
    const Scan scan = read(flaser(ranges, "0 0 0", "1")).readings.at(0).scan.value();
    EXPECT_NEAR(degrees(scan.angle_first), -90.0, 1e-12);
    EXPECT_NEAR(degrees(scan.angle_increment), degrees_apart, 1e-12);
  }
}

TEST_F(CarmenLogFile, ReadsTheNewStyle) {
  const CarmenLog log = read(
      "ROBOTLASER1 0 -1.570796 3.141593 0.0174533 20.0 0.01 1 3 1 19.9 20 2 7 8 "
      "1.2 2 0 1 2 0 0.4 0.05 0.3 0.3 1000 -12.25 host 4\n");
  const Reading& r = log.readings.at(0);
  EXPECT_EQ(log.odometry[0], (Pose2{1.0, 2.0, 0.0}));
  EXPECT_EQ(r.stamp.ns, -12'250'000'000);
  EXPECT_EQ(r.twist, (Twist2{0.4, 0.0, 0.05}));
  ASSERT_TRUE(r.scan);
  EXPECT_EQ(r.scan->ranges, (std::vector<float>{1.0F, 19.9F, Scan::kNoReturn}));
  EXPECT_EQ(r.scan->range_max, 20.0);
  EXPECT_EQ(r.scan->angle_first, -1.570796);
  EXPECT_EQ(r.scan->angle_increment, 0.0174533);
  EXPECT_NEAR(r.scan->T_base_lidar.x, 0.2, 1e-12);
}

TEST_F(CarmenLogFile, CovarianceDoesNotDependOnHowADriveIsCut) {
  const OdometryNoise noise{.position_per_m = 0.03,
                            .position_per_rad = 0.01,
                            .heading_per_m = radians(2.0),
                            .heading_per_rad = radians(4.0),
                            .position_floor_m = 0.0,
                            .heading_floor = 0.0};
  const Eigen::Matrix3d whole = noise.covariance({2.0, 0.0, 0.0}), half = noise.covariance({1.0, 0.0, 0.0});
  EXPECT_TRUE(whole.isApprox(2.0 * half, 1e-12));
  EXPECT_NEAR(half(0, 0), 0.03 * 0.03, 1e-15);
  EXPECT_NEAR(std::sqrt(half(2, 2)), radians(2.0), 1e-12);
  EXPECT_NEAR(std::sqrt(noise.covariance({0.0, 0.0, -1.0})(2, 2)), radians(4.0), 1e-12);
  EXPECT_NEAR(std::sqrt(noise.covariance({0.0, 0.0, -1.0})(1, 1)), 0.01, 1e-12);
  EXPECT_GT(OdometryNoise{}.covariance({}).determinant(), 0.0) << "a floor at rest";
}

TEST_F(CarmenLogFile, NamesThePlaceOfABrokenLine) {
  const std::string name = file_.string();
  const std::string good = "ODOM 0 0 0 0 0 0 1 host 1\n";
  EXPECT_THAT(error(good + "ODOM 1 2 x 0 0 0 1 host 1\n"),
              testing::StartsWith(name + ":2:10: odom_theta: expected a number, found 'x'"));
  EXPECT_THAT(error(good + "FLASER 3 1 nan 1 0 0 0 0 0 0 1 host 1\n"), testing::StartsWith(name + ":2:12: range[1]: "));
  EXPECT_THAT(error(good + "FLASER 3 1 2\n"), testing::StartsWith(name + ":2:"));
  EXPECT_THAT(error(good + "FLASER 99999999999 1 2\n"), testing::StartsWith(name + ":2:8: num_readings: "));
  EXPECT_THAT(error(good + "FLASER -1 1 2\n"), testing::StartsWith(name + ":2:8: num_readings: "));
  EXPECT_THAT(error(good + "ODOM 1 2 3 0 0 0 1e300 host 1\n"),
              testing::StartsWith(name + ":2:18: timestamp: expected seconds, found '1e300'"));
  EXPECT_THAT(error(good + "ODOM 1 2 3 0 0 0\n"), testing::StartsWith(name + ":2:"));
  EXPECT_THAT(error(good + "ROBOTLASER1 0 0 0 0 20 0 0 2 1 1 0 0 0 0 0 0 0 0 0 0 0 0 1 h 1\n"),
              testing::HasSubstr(
                  ":2:19: angular_resolution: expected radians between two beams, more than 0 and at most 2 pi"));
}

TEST_F(CarmenLogFile, AFileWithoutRecordsIsNoLog) {
  EXPECT_EQ(error("hello\n"),
            file_.string() + ": no record, expected a CARMEN log with ODOM, FLASER or ROBOTLASER1 lines");
}

struct RealLog {
  const char* name;
  std::size_t records, scans, beams;
};

class RealCarmenLog : public testing::TestWithParam<RealLog> {};

TEST_P(RealCarmenLog, HasTheKnownNumbersOfRecordsAndScans) {
  const RealLog& expected = GetParam();
  const auto file = std::filesystem::path(COGSLAM_SOURCE_DIR) / "../shared/data" / expected.name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << expected.name << " is not there: it is not part of the project";
  const CarmenLog log = read_carmen_log(file);
  EXPECT_EQ(log.readings.size(), expected.records);
  EXPECT_EQ(log.odometry.size(), expected.records);
  EXPECT_EQ(log.scans, expected.scans);
  EXPECT_EQ(log.dropped_scans, 0u);
  EXPECT_EQ(log.ignored_lines, 0u);
  Pose2 T_odom_base = log.odometry.front();
  double none = 0.0, beams = 0.0;
  for (const Reading& r : log.readings) {
    T_odom_base = T_odom_base * r.motion.T_before_now;
    if (!r.scan) continue;
    ASSERT_EQ(r.scan->ranges.size(), expected.beams);
    for (const float range : r.scan->ranges) none += range == Scan::kNoReturn;
    beams += static_cast<double>(expected.beams);
  }
  EXPECT_LT((T_odom_base.position() - log.odometry.back().position()).norm(), 1e-6) << "increments add up to the path";
  EXPECT_GT(none / beams, 0.005);
  EXPECT_LT(none / beams, 0.12);
}

// Intel has 13631 ODOM lines; 21 of them repeat the line before, stamp and pose, and are no records of their own.
INSTANTIATE_TEST_SUITE_P(Logs, RealCarmenLog,
                         testing::Values(RealLog{"intel.clf.gz", 13631 - 21, 8596, 180},
                                         RealLog{"mit-csail.clf.gz", 1988, 1477, 361}),
                         [](const auto& log) { return std::string(log.index == 0 ? "Intel" : "Csail"); });

}  // namespace
}  // namespace cogslam
