#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const std::string kSimple = COGSLAM_SOURCE_DIR "/scenarios/simple.yaml";

/// A usage error: its code, nothing on standard output, and this on standard error.
void expect_usage_error(const std::vector<std::string>& arguments, const std::string& message) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.code, kUsageError);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr(message));
}

TEST(Usage, HelpIsNoError) {
  const Outcome outcome = run_program({"--help"});
  EXPECT_EQ(outcome.code, kOk);
  for (const char* word : {"run", "replay", "validate", "Exit codes"}) EXPECT_THAT(outcome.out, HasSubstr(word));
  EXPECT_EQ(outcome.err, "");
  const Outcome run = run_program({"run", "--help"});
  EXPECT_EQ(run.code, kOk);
  for (const char* option : {"--seed", "-j", "--particles", "--cell-size", "--store", "--set", "--json", "--out",
                             "--quiet", "--save-readings"}) {
    EXPECT_THAT(run.out, HasSubstr(option));
  }
}

TEST(Usage, NamesWhatIsMissingOrUnknown) {
  expect_usage_error({}, "A subcommand is required");
  expect_usage_error({"fly"}, "unknown command 'fly', expected one of run, replay, validate");
  expect_usage_error({"relay", "a.log"}, "unknown command 'relay'; did you mean 'replay'?");
  expect_usage_error({"lab", "sgnal"}, "unknown command 'sgnal'; did you mean 'signal'?");
  expect_usage_error({"lab", "tables"}, "unknown command 'tables', expected one of signal, map, figures");
  expect_usage_error({"lab", "signal", "--seeds", "1"}, "--seeds: Value 1 not in range 2 to 100000");
  expect_usage_error({"lab", "figures", "1", "--out", kSimple + "/figures"},
                     "--out " + kSimple + "/figures: Not a directory");
  expect_usage_error({"run"}, "SCENARIO is required");
  expect_usage_error({"run", kSimple, "--speed", "3"}, "--speed");
  expect_usage_error({"run", kSimple, "-j", "0"}, "--threads");
  expect_usage_error({"run", kSimple, "--store", "cloud"}, "cloud");
  expect_usage_error({"run", kSimple, "--cell-size", "-1"}, "--cell-size");
}

TEST(Usage, PassesOnWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  expect_usage_error({"run", "nowhere.yaml"}, "cogslam: nowhere.yaml: ");
  expect_usage_error({"replay", "nowhere.log"}, "cogslam: nowhere.log: ");
  const std::string file = folder.file("typo.yaml", "name: x\ndrive: {waypoints: [{x_m: 1, y_m: 0}]}\nsead: 3\n");
  expect_usage_error({"validate", file}, file + ":3:1: unknown key 'sead'; did you mean 'seed'?");
  const std::string log = folder.file("broken.log", "ODOM 1 2 three 0 0 0 1.0 host 1.0\n");
  expect_usage_error({"replay", log, "--no-files"}, log + ":1:10: ");
}

TEST(Usage, ChecksSettings) {
  expect_usage_error({"validate", kSimple, "--set", "slam"}, "--set slam: expected key=value");
  expect_usage_error({"validate", kSimple, "--set", "slam.particels=3"}, "did you mean 'particles'?");
  expect_usage_error({"validate", kSimple, "--set", "slam.particles=many"}, "--set slam.particles=many: ");
  expect_usage_error({"validate", kSimple, "--set", "variants.9.name=x"}, "--set variants.9.name=x: ");
  expect_usage_error({"validate", kSimple, "--set", "variants.1.name=og"}, "a second variant called 'og'");
  expect_usage_error({"validate", kSimple, "--set", "name=../x"}, "expected letters, digits");
}

TEST(Usage, FindsAnOutputFolderThatCannotBeBeforeItRuns) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file", "");
  expect_usage_error({"run", kSimple, "--out", file}, "--out " + file + ": Not a directory, expected a folder");
  expect_usage_error({"run", kSimple, "--out", file + "/below"}, "expected a folder");
}

TEST(Validate, PrintsTheScenarioWithSettingsAndDefaults) {
  const Outcome outcome = run_program({"validate", kSimple, "--seed", "7", "--set", "slam.particles=12"});
  EXPECT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nseed: 7\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\n  particles: 12\n"));
  EXPECT_THAT(outcome.out, HasSubstr("    noise_deg: 2\n"));
  const TemporaryFolder folder;
  const Outcome again = run_program({"validate", folder.file("resolved.yaml", outcome.out)});
  EXPECT_EQ(again.out, outcome.out);
}

TEST(Replay, AsksForAnAreaWhereTheStoreNeedsOne) {
  const TemporaryFolder folder;
  const std::string log = folder.file("still.log", "ODOM 0 0 0 0 0 0 1.0 host 1.0\n");
  expect_usage_error({"replay", log, "--store", "coefficients"}, "it needs a stated map area");
  expect_usage_error({"replay", log, "--area", "0,0,0,5"}, "expected [x0, y0, x1, y1] with x0 < x1 and y0 < y1");
}

TEST(Replay, SaysThatNothingWasMeasured) {
  const TemporaryFolder folder;
  const std::string log = folder.file("still.log", "ODOM 0 0 0 0 0 0 1.0 host 1.0\nODOM 1 0 0 0 0 0 2.0 host 2.0\n");
  const Outcome outcome = run_program({"replay", log, "--out", folder.path() / "runs"});
  EXPECT_EQ(outcome.code, kNothingMeasured);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, EndsWith("nothing measured: the readings hold no scan\n"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs"));
}

}  // namespace
}  // namespace cogslam
