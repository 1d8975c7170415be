#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/exit_codes.hpp"
#include "core/text_file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// A folder with a paper_l2.yaml of its own: three seconds of driving, two particles.
class FiguresProgram : public testing::Test {
 protected:
  void SetUp() override {
    (void)folder_.file(
        "paper_l2.yaml",
        "seeds: {first: 1, count: 3}\n"
        "worlds:\n"
        "  - scenario: " COGSLAM_SOURCE_DIR
        "/scenarios/simple.yaml\n"
        "    set: [{key: duration_s, value: 3}, {key: slam.proposal, value: motion}, {key: slam.particles, "
        "value: 2}]\n"
        "cell_sizes_m: [0.1]\n"
        "true_poses: false\n"
        "variants:\n"
        "  - {name: og, slam: {store: {kind: dense}}}\n"
        "  - {name: l2_40, slam: {store: {kind: coefficients}}}\n");
  }
  [[nodiscard]] Outcome figures(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{
        "figures", "13", "--files", folder_.path().string(), "--sweeps", at("sweeps"), "--out", at("out"), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
  [[nodiscard]] std::string csv() const { return read_text_file(at("out/figure_13.csv"), 10'000'000); }

  TemporaryFolder folder_;
};

TEST_F(FiguresProgram, RunsTheSweepOfAFigureThenDrawsItAgainWithoutRunning) {
  const Outcome made = figures({"--seeds", "1", "-j1"});
  ASSERT_EQ(made.code, kOk) << made.err;
  EXPECT_EQ(made.out, at("out") + "\n");
  for (const char* ending : {".csv", ".svg", ".png"}) {
    EXPECT_TRUE(std::filesystem::exists(at("out/figure_13") + ending)) << ending;
  }
  EXPECT_THAT(csv(), HasSubstr("\npath,l2 from the top 40 %,0,,,0,-1.3,\n")) << "the drive starts there";
  const std::string first = csv();
  const Outcome drawn = figures({"--seeds", "1", "--only-draw"});
  ASSERT_EQ(drawn.code, kOk) << drawn.err;
  EXPECT_EQ(csv(), first);

  const Outcome more = figures({"--only-draw"});
  EXPECT_EQ(more.code, kUsageError);
  EXPECT_THAT(more.err, EndsWith("sweep.sqlite: holds 2 of 6 episodes: run `cogslam sweep " + at("paper_l2.yaml") +
                                 " --out " + at("sweeps/paper_l2") + "`\n"));
}

TEST_F(FiguresProgram, SaysWhichCommandMakesAMissingTable) {
  const Outcome outcome = figures({"--only-draw"});
  EXPECT_EQ(outcome.code, kUsageError);
  EXPECT_EQ(outcome.err, "cogslam: " + at("sweeps/paper_l2/sweep.sqlite") + ": not there: run `cogslam sweep " +
                             at("paper_l2.yaml") + " --out " + at("sweeps/paper_l2") + "`\n");
}

TEST(Figures, NamesThoseThereAre) {
  const Outcome unknown = run_program({"figures", "11"});
  EXPECT_EQ(unknown.code, kUsageError);
  EXPECT_THAT(unknown.err, StartsWith("cogslam: no figure '11', expected one of 12, 13, "));
  EXPECT_THAT(run_program({"figures", "--help"}).out, HasSubstr("  24         error over the data kept"));
}

}  // namespace
}  // namespace cogslam
