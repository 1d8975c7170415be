#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "core/text_file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using testing::HasSubstr;

/// A robot that drives straight towards a wall at x = 8 m, between walls at y = +-2 m; a record every 0.5 m.
std::string corridor_log() {
  std::string log;
  for (int i = 0; i < 8; ++i) {
    const double x = 0.5 * i, stamp = 1.0 + i;
    log += fmt::format("FLASER 181");
    for (int beam = 0; beam < 181; ++beam) {
      const double angle = (beam - 90) * M_PI / 180.0;
      const double ahead = (8.0 - x) / std::max(std::cos(angle), 1e-9),
                   aside = 2.0 / std::max(std::abs(std::sin(angle)), 1e-9);
      log += fmt::format(" {:.3f}", std::min(ahead, aside));
    }
    log += fmt::format(" {0} 0 0 {0} 0 0 {1} host {1}\n", x, stamp);
  }
  return log;
}

TEST(ReplayCarmen, MapsALogAndScoresItsRelations) {
  const TemporaryFolder folder;
  const std::string log = folder.file("corridor.log", corridor_log());
  const std::string relations = folder.file("corridor.relations", "1 3 1 0 0 0 0 0\n1 8 3.5 0 0 0 0 0\n");
  const Outcome outcome =
      run_program({"replay", log, "--relations", relations, "--json", "--out", folder.path() / "runs"});
  ASSERT_EQ(outcome.code, kOk) << outcome.err;
  const ordered_json record = ordered_json::parse(outcome.out);
  EXPECT_EQ(record["scenario"], "corridor");
  EXPECT_EQ(record["simulated_s"], 7.0);
  const ordered_json& scores = record["variants"][0]["scores"];
  EXPECT_EQ(scores["registered"].get<int>() + scores["tracked"].get<int>(), 8);
  EXPECT_EQ(scores["relations"]["final"]["all"]["count"], 2);
  EXPECT_LT(scores["relations"]["final"]["all"]["trans_mean_m"], 0.1);
  EXPECT_TRUE(scores["path_mse_m2"].is_null());
  const fs::path run = fs::directory_iterator(folder.path() / "runs")->path();
  for (const char* file : {"replay.yaml", "slam_0.05m_map.png", "slam_0.05m_final.tum", "odometry.tum", "room.png"}) {
    EXPECT_TRUE(fs::exists(run / file)) << file;
  }
  EXPECT_FALSE(fs::exists(run / "truth.tum"));
  const Outcome table = run_program({"replay", log, "--relations", relations, "--no-files"});
  EXPECT_THAT(table.out, HasSubstr("global"));
}

TEST(ReplayCarmen, RunsTheVariantsOfAConfiguration) {
  const TemporaryFolder folder;
  const std::string log = folder.file("corridor.log", corridor_log());
  const std::string config = folder.file("filters.yaml", R"(
map: {area_m: [-1, -3, 9, 3]}
slam: {particles: 5, cell_sizes_m: [0.2]}
variants:
  - {name: og, slam: {store: {kind: dense}}}
  - {name: cog, slam: {store: {kind: coefficients}}}
)");
  const Outcome outcome = run_program({"replay", log, "--config", config, "--percent", "100", "--json", "--no-files"});
  ASSERT_EQ(outcome.code, kOk) << outcome.err;
  const ordered_json record = ordered_json::parse(outcome.out);
  ASSERT_EQ(record["variants"].size(), 2U);
  EXPECT_EQ(record["variants"][1]["percent_kept"], 100.0);
  EXPECT_LT(record["variants"][1]["scores"]["grid_mse_vs_baseline"], 1e-6);
  const Outcome one = run_program({"replay", log, "--store", "coefficients", "--percent", "30", "--area", "-1,-3,9,3",
                                   "--cell-size", "0.2", "--particles", "3", "--json", "--no-files"});
  ASSERT_EQ(one.code, kOk) << one.err;
  EXPECT_EQ(ordered_json::parse(one.out)["variants"][0]["percent_kept"], 30.0);
}

TEST(ReplayCarmen, TakesTheBeginningOfARealLog) {
  const fs::path log = fs::path(COGSLAM_SOURCE_DIR) / ".." / "shared" / "data" / "intel.clf.gz";
  if (!fs::exists(log)) GTEST_SKIP() << "no " << log;
  const TemporaryFolder folder;
  std::string begin;
  LineReader lines(log);
  for (int i = 0; i < 1500 && lines.next(); ++i) begin += std::string(lines.line()) + "\n";
  const Outcome outcome = run_program({"replay", folder.file("intel.clf", begin), "--json", "--no-files"});
  ASSERT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_GT(ordered_json::parse(outcome.out)["variants"][0]["scores"]["registered"], 3);
}

}  // namespace
}  // namespace cogslam
