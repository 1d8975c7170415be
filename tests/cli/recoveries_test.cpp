#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"

// FastSLAM COG with every way back, as the shipped scenario has it, for 3 of its 30 seconds.

namespace cogslam {
namespace {

using nlohmann::ordered_json;

std::vector<std::string> short_run(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"run",         COGSLAM_SOURCE_DIR "/scenarios/recoveries.yaml",
                                     "--set",       "duration_s=3",
                                     "--particles", "3",
                                     "--no-files",  "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

const ordered_json& short_record() {
  static const ordered_json kRecord = [] {
    const Outcome outcome = run_program(short_run({"--json"}));
    EXPECT_EQ(outcome.code, kOk) << outcome.err;
    return ordered_json::parse(outcome.out);
  }();
  return kRecord;
}

const ordered_json& variant(const std::string& name) {
  const ordered_json& all = short_record()["variants"];
  return *std::find_if(all.begin(), all.end(), [&](const ordered_json& v) { return v["name"] == name; });
}

std::set<std::string> all_of(const char* key) {
  std::set<std::string> found;
  for (const ordered_json& v : short_record()["variants"]) {
    if (!v[key].is_null()) found.insert(v[key].get<std::string>());
  }
  return found;
}

TEST(Recoveries, RunWithEveryBasisCompressorAndRecovery) {
  EXPECT_THAT(all_of("basis"),
              testing::ElementsAre("dct", "dct_1d", "haar", "haar_1d", "haar_standard", "hadamard", "identity"));
  EXPECT_THAT(all_of("compressor"),
              testing::ElementsAre("dct", "gaussian", "hadamard", "noiselet", "selection", "top_m"));
  EXPECT_THAT(all_of("recovery"), testing::ElementsAre("csekf", "csekf_p_gradient", "csekf_p_power", "csekf_p_printed",
                                                       "fast_l2", "nesta", "pinv", "tv"));
  for (const ordered_json& v : short_record()["variants"]) {
    EXPECT_GT(v["scores"]["registered"], 5) << v["name"];
    EXPECT_TRUE(v["scores"]["path_mse_m2"].is_number()) << v["name"];
  }
  EXPECT_TRUE(variant("og")["recovery"].is_null());
}

/// Where H picks coefficients nothing is known of the others, so that the least l1 norm is the least l2 norm.
TEST(Recoveries, ByCompressedSensingFromTopCoefficientsEqualL2) {
  const ordered_json& l2 = variant("top_l2")["scores"];
  const ordered_json& pinv = variant("top_pinv")["scores"];
  const ordered_json& cs = variant("top_cs")["scores"];
  EXPECT_EQ(cs["state_hash"], pinv["state_hash"]) << "the same in every bit: maps, poses and weights";
  EXPECT_EQ(cs["map_hash"], pinv["map_hash"]);
  // The fast path for l2 works in single precision, the general one in double.
  EXPECT_NEAR(cs["path_mse_m2"].get<double>(), l2["path_mse_m2"].get<double>(), 1e-12);
  EXPECT_NEAR(cs["heading_mse_rad2"].get<double>(), l2["heading_mse_rad2"].get<double>(), 1e-12);
  EXPECT_NEAR(cs["grid_mse"].get<double>(), l2["grid_mse"].get<double>(), 1e-7);
  EXPECT_EQ(cs["payload_bytes"], l2["payload_bytes"]);
  EXPECT_NE(cs["map_hash"], variant("top_csekf")["scores"]["map_hash"]) << "a filter is no exact recovery";
}

TEST(Recoveries, AreNamedInTheTable) {
  const Outcome outcome = run_program(short_run({"--set", "duration_s=1", "--store", "coefficients"}));
  ASSERT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("basis/compressor/recovery"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\ntop_cs +0.25 +haar/top_m/nesta +60 "));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\ncells_tv +0.25 +identity/selection/tv +60 "));
}

}  // namespace
}  // namespace cogslam
