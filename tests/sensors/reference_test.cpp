#include "sensors/reference.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/statistics.hpp"

namespace cogslam {
namespace {

const Pose2 kTrue{1.0, -2.0, 3.1};

TEST(Reference, SpreadsByTheSigmaOfEachFix) {
  const Reference reference(ReferenceConfig{}, 4);
  std::vector<double> x, y, heading, sigma;
  for (std::uint64_t n = 0; n < 20000; ++n) {
    const ReferenceFix fix = reference.fix(kTrue, {}, n);
    x.push_back((fix.T_map_base.x - kTrue.x) / fix.sigma);
    y.push_back((fix.T_map_base.y - kTrue.y) / fix.sigma);
    heading.push_back(angle_difference(fix.T_map_base.theta, kTrue.theta) / radians(0.5));
    sigma.push_back(fix.sigma);
  }
  for (const auto& e : {x, y, heading}) {
    const Moments m = moments(e);
    EXPECT_NEAR(m.mean, 0.0, 5.0 / std::sqrt(m.count));
    EXPECT_NEAR(m.variance, 1.0, 5.0 * std::sqrt(2.0 / m.count));
  }
  EXPECT_LT(std::abs(correlation(x, y)), 5.0 / std::sqrt(20000.0));
  EXPECT_LT(std::abs(correlation(x, heading)), 5.0 / std::sqrt(20000.0));
  const Moments s = moments(sigma);
  EXPECT_GE(s.min, 0.001);
  EXPECT_LE(s.max, 0.010);
  EXPECT_NEAR(s.mean, 0.0055, 5.0 * 0.009 / std::sqrt(12.0 * s.count));
}

TEST(Reference, DrawsTheSameInAnyOrder) {
  const Reference a(ReferenceConfig{}, 4), b(ReferenceConfig{}, 4);
  const ReferenceFix first = a.fix(kTrue, {}, 1), second = a.fix(kTrue, {}, 2);
  EXPECT_EQ(b.fix(kTrue, {}, 2), second);
  EXPECT_EQ(b.fix(kTrue, {}, 1), first);
  EXPECT_NE(first.T_map_base.x, second.T_map_base.x);
}

TEST(Reference, RejectsCrossedSigmas) {
  ConfigSection s = ConfigSection::parse("sigma_min_m: 0.02\n", "r.yaml");
  try {
    read_reference_config(s);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::MatchesRegex("r.yaml:1:[0-9]+: .*sigma_min_m is above sigma_max_m, expected .*"));
  }
}

}  // namespace
}  // namespace cogslam
