#include "eval/filter_degradation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cogslam {
namespace {

/// A long run without fault.
FilterHealth sound() {
  FilterHealth health;
  health.records = 2400;
  health.odometry_checks = 300;
  health.headings = 200;
  health.scans_judged = 180;
  health.by_camera = 2400;
  health.beams_known = 20000;
  return health;
}

std::vector<std::string> keys_of(const FilterHealth& health) {
  std::vector<std::string> keys;
  for (const Degradation& degradation : degradations(health)) keys.emplace_back(degradation.key);
  return keys;
}

TEST(FilterDegradation, SaysNothingOfASoundRunNorOfAnEmptyOne) {
  EXPECT_THAT(keys_of(sound()), testing::IsEmpty());
  EXPECT_THAT(keys_of({}), testing::IsEmpty());
}

TEST(FilterDegradation, NamesEachSignOnceItIsOverItsLimit) {
  struct Case {
    const char* key;
    std::int64_t FilterHealth::*count;
    std::int64_t limit;
  };
  for (const Case& c :
       {Case{"camera_blind", &FilterHealth::by_wheels, 49}, Case{"beams_doubted", &FilterHealth::beams_doubted, 2000},
        Case{"scans_missing", &FilterHealth::scans_missing, 48},
        Case{"repeated_scans", &FilterHealth::repeated_scans, 3}, Case{"blind_scans", &FilterHealth::blind_scans, 48},
        Case{"odometry_doubted", &FilterHealth::odometry_doubted, 6},
        Case{"headings_doubted", &FilterHealth::headings_doubted, 4}, Case{"lost", &FilterHealth::longest_doubt, 10},
        Case{"particles_collapsed", &FilterHealth::collapses, 36}}) {
    FilterHealth health = sound();
    health.*c.count = c.limit - 1;
    EXPECT_THAT(keys_of(health), testing::IsEmpty()) << c.key;
    health.*c.count = c.limit;
    EXPECT_THAT(keys_of(health), testing::ElementsAre(c.key));
  }
}

}  // namespace
}  // namespace cogslam
