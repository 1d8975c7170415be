#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

// The program's gate over four seconds without camera: small, so it is asked only for what few seeds can tell.

namespace cogslam {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::string gate_file(const std::string& more) {
  return std::string("scenarios:\n  - file: ") + COGSLAM_SOURCE_DIR + R"(/scenarios/simple.yaml
    name: quick
    set:
      - {key: duration_s, value: 4}
      - {key: sensors.camera.enabled, value: "false"}
      - {key: odometry.source, value: wheel}
      - {key: sensors.lidar.beams, value: 181}
      - {key: slam.particles, value: 5}
      - {key: slam.cell_sizes_m, value: "[0.2]"}
    variants: [{name: cog40}, {name: cog40_true_poses}]
metrics:
  - {name: path_mse_m2, poses: estimated, tolerance_percent: 5, effect_percent: 400}
  - {name: grid_mse, poses: true, tolerance_percent: 1, effect_percent: 5}
  - {name: bytes, tolerance_percent: 1, effect_percent: 10}
)" + more;
}

/// A gate with its baseline, made once for all tests.
class Gate : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    gate_ = folder_->file("gate.yaml", gate_file("seeds: 10\nbaseline_seeds: 20\n"));
    update_ = new Outcome(run_program({"gate", gate_, "--update"}));
  }
  static void TearDownTestSuite() {
    delete update_;
    delete folder_;
  }

  static Outcome gate(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"gate", gate_, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  static fs::path baseline() { return folder_->path() / "baselines" / "quick.yaml"; }

  static TemporaryFolder* folder_;
  static std::string gate_;
  static Outcome* update_;
};

TemporaryFolder* Gate::folder_ = nullptr;
std::string Gate::gate_;
Outcome* Gate::update_ = nullptr;

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The figures that failed, as "variant metric".
std::vector<std::string> failed(const Outcome& outcome) {
  std::vector<std::string> names;
  const json report = json::parse(outcome.out);
  for (const auto& figure : report["results"][0]["figures"]) {
    if (figure["verdict"] == "FAIL")
      names.push_back(figure["variant"].get<std::string>() + " " + figure["metric"].get<std::string>());
  }
  return names;
}

TEST_F(Gate, WritesABaselineAndSaysWhatItCanHold) {
  EXPECT_EQ(update_->code, kOk) << update_->err;
  EXPECT_THAT(update_->out, HasSubstr("quick: 20 seeds from 1; the gate runs 10\n"));
  EXPECT_THAT(update_->out, Not(HasSubstr("not enough")));
  EXPECT_THAT(update_->err, HasSubstr("wrote " + baseline().string()));
  EXPECT_THAT(update_->err, HasSubstr("[20/20] quick, seed 20: done in "));
}

TEST_F(Gate, PassesUnchangedCodeWithFreshSeedsAndWithTheSame) {
  const Outcome fresh = gate({});
  EXPECT_EQ(fresh.code, kOk) << fresh.out << fresh.err;
  EXPECT_EQ(fresh.err, "");
  EXPECT_THAT(fresh.out, HasSubstr("quick: seeds 21 to 30 against 20 of the baseline, other seeds\n"));
  EXPECT_THAT(fresh.out, HasSubstr(": pass. 4 passed, 0 failed, 0 not measured.\n"));
  const Outcome same = gate({"--first-seed", "3", "--seeds", "12"});
  EXPECT_EQ(same.code, kOk) << same.out;
  EXPECT_THAT(same.out, HasSubstr("quick: seeds 3 to 14 against 20 of the baseline, paired: the same seeds\n"));
  EXPECT_THAT(same.out, HasSubstr("    +0.00 %    +0.00 %    +1.00 %"));
  EXPECT_EQ(gate({"--first-seed", "3", "--seeds", "12", "-j", "1"}).out, same.out) << "on one thread";
}

TEST_F(Gate, FailsPlantedRegressionsInPathMapAndBytes) {
  const Outcome path = gate({"--json", "--set", "slam.proposal=motion"});
  EXPECT_EQ(path.code, kGateFailed);
  EXPECT_THAT(failed(path), testing::Contains("cog40 path_mse_m2"));
  EXPECT_THAT(failed(path), Not(testing::Contains("cog40_true_poses grid_mse")));
  const Outcome map = gate({"--json", "--set", "variants.3.slam.log_odds.hit=0.5"});
  EXPECT_EQ(map.code, kGateFailed);
  EXPECT_THAT(failed(map), testing::Contains("cog40_true_poses grid_mse"));
  EXPECT_THAT(failed(map), Not(testing::Contains("cog40 path_mse_m2")));
  const Outcome bytes = gate({"--json", "--set", "slam.particles=4"});
  EXPECT_EQ(bytes.code, kGateFailed) << "fewer share what they share";
  EXPECT_THAT(failed(bytes), testing::ElementsAre("cog40 bytes"));
  EXPECT_THAT(json::parse(bytes.out)["results"][0]["notes"].dump(),
              HasSubstr("other settings than the baseline's: slam.particles: 5 -> 4\""));
}

TEST_F(Gate, SaysWhereItsSeedsCannotTell) {
  const Outcome outcome = gate({"--seeds", "3"});
  EXPECT_EQ(outcome.code, kNothingMeasured);
  EXPECT_THAT(outcome.out, HasSubstr("not measured: these seeds resolve +"));
  const Outcome blind = gate({"--json", "--set", "slam.sweep.beams=120", "--set", "variants.1.name=other"});
  EXPECT_EQ(blind.code, kUsageError);
  EXPECT_THAT(blind.err, HasSubstr("simple.yaml: no variant 'cog40', which the gate file names"));
}

TEST_F(Gate, SaysWhereNoScanEverCame) {
  const std::string file = folder_->file(
      "blind.yaml", "baselines: none\nseeds: 2\nbaseline_seeds: 2\nscenarios: [{file: " COGSLAM_SOURCE_DIR
                    "/scenarios/faults/lidar_dropout.yaml, name: simple, set: [{key: duration_s, value: 0.2}, {key: "
                    "faults.0.probability, value: 1}, {key: faults.0.from_s, value: 0}]}]\n");
  const Outcome update = run_program({"gate", file, "--update", "--quiet"});
  EXPECT_EQ(update.code, kNothingMeasured) << update.err;
  EXPECT_THAT(update.err, HasSubstr("simple: nothing measured, "));
  EXPECT_FALSE(fs::exists(folder_->path() / "none" / "simple.yaml"));
}

TEST_F(Gate, FailsWithoutABaselineAndSaysHowToMakeOne) {
  const TemporaryFolder elsewhere;
  const std::string file = elsewhere.file("gate.yaml", gate_file(""));
  const Outcome outcome = run_program({"gate", file, "--junit", elsewhere.path() / "gate.xml"});
  EXPECT_EQ(outcome.code, kGateFailed);
  EXPECT_THAT(outcome.out, HasSubstr("quick: no baseline: make " + elsewhere.path().string() +
                                     "/baselines/quick.yaml with --update, look at it and commit it\n"));
  EXPECT_THAT(content(elsewhere.path() / "gate.xml"), HasSubstr("failures=\"1\""));
}

TEST_F(Gate, DoesNotCompareScenariosThatDiffer) {
  const Outcome outcome = gate({"--set", "sensors.lidar.rate_hz=20", "--set", "duration_s=5"});
  EXPECT_EQ(outcome.code, kGateFailed);
  EXPECT_THAT(outcome.out,
              HasSubstr("quick: not the baseline's scenario: duration_s: 4 -> 5, sensors.lidar.rate_hz: 40 "
                        "-> 20; if that is meant, make "));
  EXPECT_THAT(gate({"--first-seed", "15"}).out, HasSubstr("seeds 15 to 24: some are the baseline's (1 to 20)"));
}

TEST_F(Gate, UpdatesOnlyWhenTold) {
  const std::string before = content(baseline());
  (void)gate({"--seeds", "2"});
  EXPECT_EQ(content(baseline()), before);
  const Outcome again = gate({"--update"});
  EXPECT_EQ(again.code, kOk);
  EXPECT_EQ(content(baseline()), before) << "the same program makes the same baseline";
  for (const std::vector<std::string>& with :
       {std::vector<std::string>{"--seeds", "5"}, {"--set", "slam.particles=5"}, {"--json"}}) {
    std::vector<std::string> arguments{"gate", gate_, "--update"};
    arguments.insert(arguments.end(), with.begin(), with.end());
    EXPECT_EQ(run_program(arguments).code, kUsageError) << with[0];
  }
  EXPECT_EQ(content(baseline()), before);
}

TEST_F(Gate, WritesJUnitThatAnXmlReaderTakes) {
  const std::string file = folder_->path() / "gate.xml";
  EXPECT_EQ(gate({"--junit", file, "--set", "slam.particles=4"}).code, kGateFailed);
  const std::string xml = content(file);
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"quick\" tests=\"4\" failures=\"1\" errors=\"0\">"));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"quick.cog40 0.2 m\" name=\"path_mse_m2\"/>"));
  if (std::system("python3 -c pass 2>/dev/null") != 0) GTEST_SKIP() << "no python3 to read the XML with";
  EXPECT_EQ(
      std::system(("python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' " + file).c_str()), 0);
}

TEST_F(Gate, StopsAtAnInterruptAndWritesNothing) {
  const TemporaryFolder elsewhere;
  const std::string file = elsewhere.file("gate.yaml", gate_file("baseline_seeds: 2000\n"));
  const Outcome outcome = run_program({"gate", file, "--update"}, {.interrupt_at = "quick, seed 2"});
  EXPECT_EQ(outcome.code, kInterrupted);
  EXPECT_FALSE(fs::exists(elsewhere.path() / "baselines" / "quick.yaml"));
}

TEST_F(Gate, FindsAFolderThatCannotBeWrittenBeforeItRuns) {
  const TemporaryFolder elsewhere;
  (void)elsewhere.file("baselines", "a file");
  const Outcome outcome = run_program({"gate", elsewhere.file("gate.yaml", gate_file("")), "--update"});
  EXPECT_EQ(outcome.code, kUsageError);
  EXPECT_THAT(outcome.err, HasSubstr("/baselines: baselines cannot be written there"));
}

}  // namespace
}  // namespace cogslam
