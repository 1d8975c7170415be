#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

// A run that sees nothing says so.

namespace cogslam {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

std::vector<std::string> short_run(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"run",         COGSLAM_SOURCE_DIR "/scenarios/simple.yaml",
                                     "--set",       "duration_s=1",
                                     "--particles", "3",
                                     "--cell-size", "0.2",
                                     "--no-files",  "--quiet",
                                     "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> degraded(const ordered_json& variant) { return variant["scores"]["degraded"]; }

TEST(Degraded, IsNoRunThatSees) {
  const Outcome outcome = run_program(short_run({}));
  ASSERT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const auto& variant : ordered_json::parse(outcome.out)["variants"]) {
    EXPECT_THAT(degraded(variant), testing::IsEmpty()) << variant["name"];
  }
}

TEST(Degraded, IsARunWhoseLidarReachesNoWall) {
  const Outcome outcome = run_program(short_run({"--set", "sensors.lidar.range_max_m=0.2"}));
  ASSERT_EQ(outcome.code, kOk) << outcome.err;
  const ordered_json variants = ordered_json::parse(outcome.out)["variants"];
  ASSERT_EQ(variants.size(), 4U);
  for (const auto& variant : variants) {
    std::vector<std::string> expected{"no_returns", "empty_map"};
    if (variant["particles"] > 1) expected.emplace_back("blind_scans");  // a filter notices; true poses tell nothing
    EXPECT_EQ(degraded(variant), expected) << variant["name"];
  }
  EXPECT_EQ(outcome.err,
            "cogslam: degraded result (blind_scans, 2 of 4 filters): scans of which hardly a beam came back\n"
            "cogslam: degraded result (empty_map, 4 of 4 filters): no scan changed the map: look at the map's area and "
            "the lidar's range\n"
            "cogslam: degraded result (no_returns, 4 of 4 filters): no beam of any scan came back from a surface: the "
            "path is odometry's\n");
}

TEST(Degraded, IsAMapWhoseAreaLiesElsewhere) {
  const TemporaryFolder folder;
  const std::string log = folder.file("still.log", "FLASER 4 1.5 1.4 1.3 1.2 0 0 0 0 0 0 1 host 1\n");
  const Outcome outcome = run_program({"replay", log, "--area", "100,100,110,110", "--no-files", "--json", "--quiet"});
  ASSERT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_THAT(degraded(ordered_json::parse(outcome.out)["variants"][0]), testing::ElementsAre("empty_map"));
  EXPECT_THAT(outcome.err, HasSubstr("degraded result (empty_map, 1 of 1 filters)"));
}

}  // namespace
}  // namespace cogslam
