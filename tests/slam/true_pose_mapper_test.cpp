#include "slam/true_pose_mapper.hpp"

#include <gmock/gmock.h>

#include "tests/support/slam_run.hpp"

namespace cogslam {
namespace {

/// The filter's own map is what the mapper makes of the filter's own path, cell by cell, when nothing is resampled.
TEST(TruePoseMapper, MakesTheFiltersMapFromTheFiltersPath) {
  const SyntheticLog log = drive_round(60, 13);
  for (const auto& [name, varied] : variants_for(log)) {
    SlamConfig config = varied;
    config.particles = 1;
    config.tracker.used = false;  // the mapper registers by odometry
    const Outcome filter = run(config, log);
    TruePoseMapper mapper(config);
    std::size_t next = 0;
    for (std::size_t i = 0; i < log.readings.size(); ++i) {
      const bool registered = next < filter.path.size() && filter.path[next].record == i;
      const Pose2 T_map_base = registered ? filter.path[next++].T_map_base : Pose2{};
      EXPECT_EQ(mapper.update(log.readings[i], T_map_base), registered) << name;
    }
    EXPECT_EQ(mapper.map(), filter.map) << name;
    EXPECT_EQ(mapper.statistics().registered, filter.statistics.registered);
    EXPECT_EQ(mapper.statistics().tracked, filter.statistics.tracked);
    EXPECT_EQ(mapper.statistics().payload_bytes, filter.statistics.payload_bytes) << name;
  }
}

}  // namespace
}  // namespace cogslam
