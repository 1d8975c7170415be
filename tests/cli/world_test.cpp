#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/exit_codes.hpp"
#include "core/text_file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;

const std::filesystem::path kScenarios = std::filesystem::path(COGSLAM_SOURCE_DIR) / "scenarios";

std::string content(const std::filesystem::path& file) { return read_text_file(file, 10'000'000); }

TEST(WorldExport, WritesAMapThatIsAWorldWithTheSameMap) {
  const TemporaryFolder folder;
  const std::string first = folder.path() / "first.yaml", second = folder.path() / "second.yaml";
  ASSERT_EQ(run_program({"world", "export", kScenarios / "cluttered.yaml", "--map", first}).code, kOk);
  const std::string scenario =
      folder.file("again.yaml",
                  "world: {kind: map, map: first.yaml, start: {y_m: -2.3}}\ndrive: {waypoints: [{x_m: 0, y_m: 0}]}\n");
  const Outcome again = run_program({"world", "export", scenario, "--map", second, "--svg", folder.path() / "w.svg"});
  ASSERT_EQ(again.code, kOk) << again.err;
  EXPECT_EQ(content(folder.path() / "second.pgm"), content(folder.path() / "first.pgm"));
  EXPECT_THAT(content(folder.path() / "w.svg"), HasSubstr("<title>again, 1:50</title>"));
}

TEST(WorldExport, GivesBackTheMapOfAShippedScenario) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"world", "export", kScenarios / "flat.yaml", "--map", folder.path() / "flat.yaml"}).code, kOk);
  const std::string scenario = folder.file(
      "s.yaml",
      "world: {kind: map, map: flat.yaml, start: {x_m: 1.2, y_m: 4.3}}\ndrive: {waypoints: [{x_m: 0, y_m: 0}]}\n");
  ASSERT_EQ(run_program({"world", "export", scenario, "--map", folder.path() / "back.yaml"}).code, kOk);
  EXPECT_EQ(content(folder.path() / "back.pgm"), content(folder.path() / "flat.pgm"));
}

TEST(WorldExport, SaysWhatIsMissing) {
  const std::string scenario = kScenarios / "simple.yaml";
  EXPECT_THAT(run_program({"world", "export", scenario}).err,
              HasSubstr("nothing to export, expected --svg FILE or --map FILE"));
  EXPECT_EQ(run_program({"world", "export", scenario, "--map", "x.pgm"}).code, kUsageError);
  EXPECT_THAT(run_program({"world", "export", scenario, "--svg", "/nowhere/x.svg"}).err,
              HasSubstr("/nowhere/x.svg: cannot be written"));
  EXPECT_THAT(
      run_program({"world", "export", kScenarios / "hallway.yaml", "--map", "x.yaml", "--cell-size", "0.005"}).err,
      HasSubstr("more than 16777216 cells"));
}

TEST(RunOfAMap, LeavesAFolderThatRunsAgainAndIsTheSame) {
  const TemporaryFolder folder;
  std::vector<std::string> first{"run", kScenarios / "flat.yaml", "--quiet", "--out", folder.path()};
  for (const char* setting : {"duration_s=2", "sensors.camera.enabled=false"}) {
    first.insert(first.end(), {"--set", setting});
  }
  ASSERT_EQ(run_program(first).code, kOk);
  const auto run_folders = [&folder] {
    std::vector<std::filesystem::path> runs;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) runs.push_back(entry.path());
    return runs;
  };
  ASSERT_EQ(run_folders().size(), 1u);
  const std::filesystem::path run = run_folders()[0];
  EXPECT_THAT(content(run / "scenario.yaml"), HasSubstr("\n  map: world.yaml\n"));
  std::filesystem::rename(run, folder.path() / "moved");
  const Outcome again =
      run_program({"run", folder.path() / "moved" / "scenario.yaml", "--quiet", "--out", folder.path()});
  ASSERT_EQ(again.code, kOk) << again.err;
  EXPECT_TRUE(std::filesystem::exists(run)) << "named by content, wherever the map lay";
}

}  // namespace
}  // namespace cogslam
