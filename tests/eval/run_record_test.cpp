#include "eval/run_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/angle.hpp"

namespace cogslam {
namespace {

using nlohmann::json;

RunRecord record_of_one() {
  RunRecord record{.scenario = "cluttered", .seed = 7, .readings_hash = "00ff", .simulated_s = 60.0};
  VariantRecord v{.name = "og", .store = "dense", .cell_size_m = 0.1, .particles = 100};
  v.scores.path_mse_m2 = 0.1 + 0.2;
  v.scores.registered = 12;
  v.scores.resamplings = 0;
  v.scores.grid_confusion = {{{1, 2, 3}, {4, 5, 6}}};
  v.scores.relations_final = RelationErrors{.local = {3, 0.25, 0.5, radians(90), radians(45)}, .unmatched = 2};
  v.costs.cpu_s = 1.5;
  record.variants.push_back(v);
  return record;
}

TEST(RunRecord, KeepsTheKeysOfSchemaOne) {
  const json j = json::parse(to_json(record_of_one()));
  EXPECT_EQ(j["schema"], 1);
  for (const char* key : {"scenario", "seed", "readings_hash", "simulated_s", "variants"})
    EXPECT_TRUE(j.contains(key)) << key;
  const json& v = j["variants"][0];
  for (const char* key : {"name", "store", "cell_size_m", "percent_kept", "basis", "compressor", "recovery",
                          "particles", "scores", "costs"}) {
    EXPECT_TRUE(v.contains(key)) << key;
  }
  for (const char* key :
       {"path_mse_m2", "heading_mse_rad2", "odometry_path_mse_m2", "ate_rmse_m", "grid_mse", "grid_mse_all",
        "grid_mse_logodds", "path_mse_vs_baseline_m2", "grid_mse_vs_baseline", "registered", "tracked", "resamplings",
        "ancestors_100", "payload_bytes", "bytes", "bytes_peak", "state_hash", "relations"}) {
    EXPECT_TRUE(v["scores"].contains(key)) << key;
  }
  for (const char* key : {"cpu_s", "cpu_ms_per_registered", "cpu_stages_s", "wall_s", "rss_bytes_above_start"}) {
    EXPECT_TRUE(v["costs"].contains(key)) << key;
  }
}

TEST(RunRecord, WritesEveryFigureUnderItsOwnKey) {
  RunRecord record;
  VariantRecord v;
  Scores& s = v.scores;
  s.path_mse_m2 = 1.5, s.heading_mse_rad2 = 2.5, s.path_mse_final_m2 = 3.5, s.heading_mse_final_rad2 = 4.5;
  s.odometry_path_mse_m2 = 5.5, s.odometry_heading_mse_rad2 = 6.5, s.ate_rmse_m = 7.5;
  s.rpe_trans_m = 8.5, s.rpe_rot_rad = 9.5, s.grid_mse = 10.5, s.grid_mse_all = 11.5, s.grid_mse_logodds = 12.5;
  s.grid_log_score = 13.5, s.path_mse_vs_baseline_m2 = 14.5, s.grid_mse_vs_baseline = 15.5;
  s.registered = 16, s.tracked = 17, s.resamplings = 18, s.ancestors_100 = 19;
  s.payload_bytes = 20.5, s.bytes = 21.5, s.bytes_peak = 22, s.degraded = {kNoReturns, kEmptyMap}, s.state_hash = "23",
  s.map_hash = "24";
  s.health = FilterHealth{31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46};
  v.costs = {.cpu_s = 25.5,
             .cpu_ms_per_registered = 26.5,
             .cpu_stages_s = StageSeconds{1, 2, 3, 4, 5, 6, 7},
             .wall_s = 27.5,
             .rss_bytes_above_start = 28};
  record.variants.push_back(v);
  const json written = json::parse(to_json(record))["variants"][0];
  const json scores{{"path_mse_m2", 1.5},
                    {"heading_mse_rad2", 2.5},
                    {"path_mse_final_m2", 3.5},
                    {"heading_mse_final_rad2", 4.5},
                    {"odometry_path_mse_m2", 5.5},
                    {"odometry_heading_mse_rad2", 6.5},
                    {"ate_rmse_m", 7.5},
                    {"rpe_trans_m", 8.5},
                    {"rpe_rot_rad", 9.5},
                    {"grid_mse", 10.5},
                    {"grid_mse_all", 11.5},
                    {"grid_mse_logodds", 12.5},
                    {"grid_log_score", 13.5},
                    {"grid_confusion", nullptr},
                    {"path_mse_vs_baseline_m2", 14.5},
                    {"grid_mse_vs_baseline", 15.5},
                    {"registered", 16},
                    {"tracked", 17},
                    {"resamplings", 18},
                    {"ancestors_100", 19},
                    {"payload_bytes", 20.5},
                    {"payload_bytes_bitmap", nullptr},
                    {"bytes", 21.5},
                    {"bytes_peak", 22},
                    {"degraded", {"no_returns", "empty_map"}},
                    {"health",
                     {{"records", 31},
                      {"scans_missing", 32},
                      {"blind_scans", 33},
                      {"repeated_scans", 34},
                      {"by_camera", 35},
                      {"by_wheels", 36},
                      {"odometry_checks", 37},
                      {"odometry_doubted", 38},
                      {"headings", 39},
                      {"headings_doubted", 40},
                      {"scans_judged", 41},
                      {"scans_doubted", 42},
                      {"beams_known", 43},
                      {"beams_doubted", 44},
                      {"longest_doubt", 45},
                      {"collapses", 46}}},
                    {"state_hash", "23"},
                    {"map_hash", "24"},
                    {"relations", {{"online", nullptr}, {"final", nullptr}}}};
  EXPECT_EQ(written["scores"], scores);
  const json stages{{"track", 1.0}, {"prepare", 2.0}, {"load", 3.0},    {"weigh", 4.0},
                    {"write", 5.0}, {"settle", 6.0},  {"resample", 7.0}};
  const json costs{{"cpu_s", 25.5},
                   {"cpu_ms_per_registered", 26.5},
                   {"cpu_stages_s", stages},
                   {"wall_s", 27.5},
                   {"rss_bytes_above_start", 28}};
  EXPECT_EQ(written["costs"], costs);
}

TEST(RunRecord, WritesNullForWhatWasNotMeasuredAndZeroForZero) {
  const json v = json::parse(to_json(record_of_one()))["variants"][0];
  for (const char* key : {"percent_kept", "basis", "compressor", "recovery"}) EXPECT_TRUE(v[key].is_null()) << key;
  EXPECT_TRUE(v["scores"]["grid_mse"].is_null());
  EXPECT_TRUE(v["scores"]["health"].is_null());
  EXPECT_TRUE(v["scores"]["relations"]["online"].is_null());
  EXPECT_TRUE(v["scores"]["relations"]["final"]["global"]["trans_mean_m"].is_null());
  EXPECT_EQ(v["scores"]["relations"]["final"]["global"]["count"], 0);
  EXPECT_EQ(v["scores"]["resamplings"], 0);
  EXPECT_EQ(v["scores"]["registered"], 12);
}

TEST(RunRecord, WritesNullForNumbersThatAreNotFinite) {
  RunRecord record = record_of_one();
  record.variants[0].scores.grid_mse = std::numeric_limits<double>::quiet_NaN();
  record.variants[0].scores.ate_rmse_m = std::numeric_limits<double>::infinity();
  const json scores = json::parse(to_json(record))["variants"][0]["scores"];
  EXPECT_TRUE(scores["grid_mse"].is_null());
  EXPECT_TRUE(scores["ate_rmse_m"].is_null());
}

TEST(RunRecord, NamesThePartsOfACompression) {
  RunRecord record = record_of_one();
  VariantRecord& v = record.variants[0];
  v.percent_kept = 60.0, v.basis = "haar", v.compressor = "hadamard", v.recovery = "csekf";
  const json written = json::parse(to_json(record))["variants"][0];
  EXPECT_EQ(written["basis"], "haar");
  EXPECT_EQ(written["compressor"], "hadamard");
  EXPECT_EQ(written["recovery"], "csekf");
}

TEST(RunRecord, ReportsRelationsInDegrees) {
  const json local = json::parse(to_json(record_of_one()))["variants"][0]["scores"]["relations"]["final"]["local"];
  EXPECT_EQ(local["count"], 3);
  EXPECT_EQ(local["trans_mean_m"], 0.25);
  EXPECT_EQ(local["trans_std_m"], 0.5);
  EXPECT_NEAR(local["rot_mean_deg"].get<double>(), 90.0, 1e-12);
  EXPECT_NEAR(local["rot_std_deg"].get<double>(), 45.0, 1e-12);
}

TEST(RunRecord, NamesTheCountsOfTheConfusionTable) {
  const json table = json::parse(to_json(record_of_one()))["variants"][0]["scores"]["grid_confusion"];
  EXPECT_EQ(table["truth_free"], (json{{"free", 1}, {"unknown", 2}, {"occupied", 3}}));
  EXPECT_EQ(table["truth_occupied"], (json{{"free", 4}, {"unknown", 5}, {"occupied", 6}}));
}

TEST(RunRecord, WritesNumbersThatReadBackExactly) {
  const std::string text = to_json(record_of_one());
  EXPECT_THAT(text, testing::HasSubstr("\"path_mse_m2\": 0.30000000000000004,"));
  EXPECT_THAT(text, testing::HasSubstr("\"cell_size_m\": 0.1,"));
  EXPECT_EQ(json::parse(text)["variants"][0]["scores"]["path_mse_m2"].get<double>(), 0.1 + 0.2);
}

TEST(RunRecord, GivesTheSameBytesForTheSameRecordAndOrderedKeys) {
  const std::string text = to_json(record_of_one());
  EXPECT_EQ(text, to_json(record_of_one()));
  EXPECT_EQ(text.rfind("{\n  \"schema\": 1,\n  \"scenario\": \"cluttered\",\n  \"seed\": 7,", 0), 0U);
  EXPECT_EQ(text.back(), '\n');
}

TEST(RunRecord, ScoresAloneDoNotDependOnCosts) {
  RunRecord slow = record_of_one(), other = record_of_one();
  slow.variants[0].costs.cpu_s = 99.0;
  other.variants[0].scores.tracked = 1;
  EXPECT_NE(to_json(slow), to_json(record_of_one()));
  EXPECT_EQ(scores_json(slow), scores_json(record_of_one()));
  EXPECT_NE(scores_json(other), scores_json(record_of_one()));
}

}  // namespace
}  // namespace cogslam
