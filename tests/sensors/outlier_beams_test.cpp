#include "sensors/faults/outlier_beams.hpp"

#include <gmock/gmock.h>

#include "tests/support/error_text.hpp"
#include "tests/support/statistics.hpp"

namespace cogslam {
namespace {

Scan scan_of_ones(std::size_t beams) {
  Scan scan;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges.assign(beams, 1.0F);
  return scan;
}

std::vector<double> changed(const Scan& scan) {
  std::vector<double> ranges;
  for (const float r : scan.ranges) {
    if (r != 1.0F) ranges.push_back(static_cast<double>(r));
  }
  return ranges;
}

TEST(OutlierBeams, SpreadTheStatedShareOfBeamsEvenlyOverTheirRanges) {
  Scan scan = scan_of_ones(20000);
  add_outliers({.share = 0.2, .shortest = 2.0, .longest = 6.0}, 1, 0, scan);
  const std::vector<double> ranges = changed(scan);
  const Moments m = moments(ranges);
  EXPECT_NEAR(m.count, 4000.0, 5.0 * std::sqrt(20000 * 0.2 * 0.8));
  EXPECT_GE(m.min, 2.0);
  EXPECT_LE(m.max, 6.0);
  EXPECT_NEAR(m.mean, 4.0, 5.0 * 4.0 / std::sqrt(12.0 * m.count));
  EXPECT_NEAR(m.variance, 16.0 / 12.0, 0.1);
}

TEST(OutlierBeams, StayWithinWhatTheScanCanSay) {
  Scan scan = scan_of_ones(5000);
  add_outliers({.share = 1.0, .shortest = 0.0, .longest = 1000.0}, 1, 0, scan);
  for (const float r : scan.ranges) {
    EXPECT_GE(r, 0.1F);
    EXPECT_LE(r, 30.0F);
  }
}

TEST(OutlierBeams, AreOthersInEverySweepAndTheSameForTheSameSeed) {
  Scan a = scan_of_ones(100), b = a, c = a, d = a;
  const OutlierBeams fault{.share = 0.5};
  add_outliers(fault, 1, 7, a);
  add_outliers(fault, 1, 7, b);
  add_outliers(fault, 1, 8, c);
  add_outliers(fault, 2, 7, d);
  EXPECT_EQ(a, b);
  EXPECT_NE(a, c);
  EXPECT_NE(a, d);
}

TEST(OutlierBeams, ReadTheirPlaceInTheFile) {
  ConfigSection section = ConfigSection::parse("{share: 0.3, shortest_m: 5, longest_m: 4}", "f.yaml");
  EXPECT_EQ(error_text([&] { read_outlier_beams(section, 0); }),
            "f.yaml:1:29: longest_m is not above shortest_m, expected shortest_m < longest_m");
}

}  // namespace
}  // namespace cogslam
