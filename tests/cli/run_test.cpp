#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using testing::HasSubstr;

/// Every stage, the camera too, in few seconds.
std::vector<std::string> short_run(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{
      "run", COGSLAM_SOURCE_DIR "/scenarios/cluttered.yaml", "--set", "duration_s=4", "--particles", "7"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// The `scores` parts as bytes, with what they are scores of.
std::string scores_of(const ordered_json& record) {
  std::string scores = record["readings_hash"].dump();
  for (const auto& variant : record["variants"]) {
    scores += "\n" + variant["name"].dump() + variant["cell_size_m"].dump() + variant["scores"].dump();
  }
  return scores;
}

fs::path only_folder_in(const fs::path& parent) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(parent)) found.push_back(entry.path());
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? fs::path() : found.front();
}

TEST(Run, GivesTheSameScoresWithAnyNumberOfThreadsInAnyProcess) {
  const Outcome first = run_program(short_run({"-j", "1", "--json", "--no-files"}));
  ASSERT_EQ(first.code, kOk) << first.err;
  const std::string scores = scores_of(ordered_json::parse(first.out));
  EXPECT_THAT(scores, HasSubstr("state_hash\":\""));
  for (const char* threads : {"2", "1"}) {
    const Outcome again = run_program(short_run({"-j", threads, "--json", "--no-files"}));
    EXPECT_EQ(scores_of(ordered_json::parse(again.out)), scores) << "-j " << threads;
  }
  const Outcome other = run_program(short_run({"--seed", "2", "--json", "--no-files"}));
  EXPECT_NE(scores_of(ordered_json::parse(other.out)), scores) << "another seed";
}

TEST(Run, PrintsOneJsonObjectAndNothingElse) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(short_run({"--json", "--quiet", "--cell-size", "0.5", "--out", folder.path()}));
  ASSERT_EQ(outcome.code, kOk);
  EXPECT_EQ(outcome.err, "");
  const ordered_json record = ordered_json::parse(outcome.out);
  EXPECT_EQ(record["schema"], 1);
  EXPECT_EQ(record["scenario"], "cluttered");
  ASSERT_EQ(record["variants"].size(), 4U);
  for (const auto& variant : record["variants"]) EXPECT_EQ(variant["cell_size_m"], 0.5);
  EXPECT_EQ(record["variants"][0]["particles"], 7);
  std::ifstream file(only_folder_in(folder.path()) / "scores.json");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), outcome.out);
}

TEST(Run, PrintsATableAndTellsOfItsStages) {
  const Outcome outcome = run_program(short_run({"--store", "coefficients", "--cell-size", "0.5", "--no-files"}));
  ASSERT_EQ(outcome.code, kOk);
  EXPECT_THAT(outcome.out, testing::StartsWith("variant"));
  EXPECT_THAT(outcome.out, HasSubstr("\ncog40 "));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("\nog ")));
  EXPECT_THAT(outcome.err, HasSubstr("[1/3] simulating cluttered\n[1/3] simulating cluttered: done in "));
  EXPECT_THAT(outcome.err, HasSubstr("[3/3] cog40_true_poses 0.5 m: done in "));
}

TEST(Run, ReplaysItsReadingsToTheSameState) {
  const TemporaryFolder folder;
  const Outcome run = run_program(short_run({"--json", "--quiet", "--save-readings", "--out", folder.path()}));
  ASSERT_EQ(run.code, kOk) << run.err;
  const fs::path saved = only_folder_in(folder.path());
  std::vector<std::string> arguments{"replay", saved / "readings.bin", "--scenario", saved / "scenario.yaml",
                                     "--json", "--no-files",           "-j",         "1"};
  const Outcome blind = run_program(arguments);
  ASSERT_EQ(blind.code, kOk) << blind.err;
  EXPECT_THAT(blind.err, HasSubstr("left out 8 variants that need the true poses"));
  const ordered_json ran = ordered_json::parse(run.out), replayed = ordered_json::parse(blind.out);
  ASSERT_EQ(replayed["variants"].size(), 8U);
  for (const auto& variant : replayed["variants"]) {
    const auto twin = std::find_if(ran["variants"].begin(), ran["variants"].end(), [&](const ordered_json& v) {
      return v["name"] == variant["name"] && v["cell_size_m"] == variant["cell_size_m"];
    });
    ASSERT_NE(twin, ran["variants"].end());
    EXPECT_EQ(variant["scores"]["state_hash"], (*twin)["scores"]["state_hash"]);
    EXPECT_TRUE(variant["scores"]["path_mse_m2"].is_null()) << "the truth was not told";
  }
  arguments.insert(arguments.end(), {"--truth", saved / "truth.bin"});
  const Outcome scored = run_program(arguments);
  EXPECT_EQ(scores_of(ordered_json::parse(scored.out)), scores_of(ran));
}

TEST(Run, StopsAtAnInterruptAndLeavesNothing) {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "runs";
  const Outcome outcome =
      run_program({"run", COGSLAM_SOURCE_DIR "/scenarios/simple.yaml", "--set", "duration_s=600", "--out", out},
                  {.interrupt_at = "simulating simple"});
  EXPECT_EQ(outcome.code, kInterrupted);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("interrupted, nothing written"));
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace cogslam
