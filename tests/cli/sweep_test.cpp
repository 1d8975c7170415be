#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/exit_codes.hpp"
#include "eval/scenario.hpp"
#include "eval/sweep/folder.hpp"
#include "eval/sweep/plan.hpp"
#include "sensors/log/recording.hpp"
#include "sensors/log/truth_log.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/sweep_files.hpp"

namespace cogslam {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Sweep, GivesTheSameScoresWithAnyNumberOfWorkers) {
  const ShortSweep sweep;
  const Outcome first = run_program(sweep.words("a", {"-j", "1"}));
  ASSERT_EQ(first.code, kOk) << first.err;
  EXPECT_THAT(first.err, HasSubstr("sweep: 16 episodes, 0 there, 16 to measure"));
  EXPECT_THAT(first.out, HasSubstr("cog_true_poses"));
  ASSERT_EQ(run_program(sweep.words("b", {"-j", "3", "--quiet"})).code, kOk);
  const std::string scores = content_of(sweep.out("a") / "scores.csv");
  EXPECT_EQ(std::count(scores.begin(), scores.end(), '\n'), 1 + ShortSweep::kEpisodes);
  EXPECT_EQ(content_of(sweep.out("b") / "scores.csv"), scores);
  EXPECT_EQ(content_of(sweep.out("b") / "summary.csv"), content_of(sweep.out("a") / "summary.csv"));
  EXPECT_EQ(files_in(sweep.out("a") / "readings", ".bin").size(), 2U * 4) << "readings and truth, once per seed";
}

TEST(Sweep, ReplaysAnEpisodeByTheCommandInItsLog) {
  const ShortSweep sweep;
  ASSERT_EQ(run_program(sweep.words("a", {"--quiet"})).code, kOk);
  for (const fs::path& file : files_in(sweep.out("a") / "episodes", ".json")) {
    const auto result = nlohmann::json::parse(content_of(file));
    if (result["run"]["seed"] != 3) continue;
    std::istringstream log(content_of(fs::path(file).replace_extension(".log")));
    std::vector<std::string> words;
    std::string word;
    std::getline(log, word);
    std::istringstream command(word.substr(std::string("replay: cogslam ").size()));
    while (command >> word) words.push_back(word);
    words.insert(words.end(), {"--no-files", "--json", "--quiet"});
    const Outcome replayed = run_program(words);
    ASSERT_EQ(replayed.code, kOk) << replayed.err;
    EXPECT_EQ(nlohmann::json::parse(replayed.out)["variants"].back()["scores"], result["run"]["variants"][0]["scores"]);
  }
}

TEST(Sweep, MeasuresOnlyWhatIsMissing) {
  const ShortSweep sweep;
  ASSERT_EQ(run_program(sweep.words("a")).code, kOk);
  const std::string costs = content_of(sweep.out("a") / "costs.csv");
  const Outcome again = run_program(sweep.words("a"));
  EXPECT_THAT(again.err, HasSubstr("16 episodes, 16 there, 0 to measure"));
  EXPECT_EQ(content_of(sweep.out("a") / "costs.csv"), costs) << "nothing was measured again";

  sweep.write_scenario(std::string(ShortSweep::kScenario) + "map: {margin_m: 0.5}\n");
  const Outcome other = run_program(sweep.words("a"));
  EXPECT_THAT(other.err, HasSubstr("16 episodes, 0 there, 16 to measure"));
  EXPECT_EQ(files_in(sweep.out("a") / "readings", ".bin").size(), 2U * 4) << "the drives are the same";
  EXPECT_NE(content_of(sweep.out("a") / "costs.csv"), costs);

  sweep.write_scenario(ShortSweep::kScenario);
  EXPECT_EQ(run_program(sweep.words("a")).code, kOk);
  EXPECT_EQ(content_of(sweep.out("a") / "costs.csv"), costs) << "the old rows are still there";
}

TEST(Sweep, MakesDamagedReadingsAndBaselinesAnew) {
  const ShortSweep sweep;
  ASSERT_EQ(run_program(sweep.words("a", {"--quiet"})).code, kOk);
  const std::string scores = content_of(sweep.out("a") / "scores.csv");
  for (const fs::path& file : files_in(sweep.out("a") / "readings", ".bin")) fs::resize_file(file, 100);
  for (const fs::path& file : files_in(sweep.out("a") / "baselines", ".bin")) fs::resize_file(file, 100);
  for (const fs::path& file : files_in(sweep.out("a") / "episodes", ".json")) {
    if (content_of(file).find("\"cog") != std::string::npos) fs::remove(file);
  }
  fs::remove(sweep.out("a") / "sweep.sqlite");
  const Outcome again = run_program(sweep.words("a"));
  EXPECT_EQ(again.code, kOk);
  EXPECT_THAT(again.err, HasSubstr("16 episodes, 8 there, 8 to measure"));
  EXPECT_EQ(content_of(sweep.out("a") / "scores.csv"), scores);
}

TEST(Sweep, PrintsWhatItWouldDo) {
  const ShortSweep sweep;
  const Outcome list = run_program(sweep.words("a", {"--dry-run"}));
  EXPECT_EQ(list.code, kOk);
  EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '\n'), ShortSweep::kEpisodes);
  EXPECT_THAT(list.out, HasSubstr(" room 0.2 m cog_true_poses seed 4\n"));
  const Outcome script = run_program(sweep.words("a", {"--dry-run", "--engine", "slurm", "--chunk", "4", "--partition",
                                                       "big", "--time", "10:00", "--account", "me"}));
  EXPECT_THAT(script.out, HasSubstr("#SBATCH --array=0-3\n"));
  EXPECT_THAT(script.out, HasSubstr("#SBATCH --partition=big\n#SBATCH --time=10:00\n#SBATCH --account=me\n"));
  EXPECT_THAT(script.out, HasSubstr("/slurm/1/'\"$SLURM_ARRAY_TASK_ID\".jobs\n"));
  EXPECT_FALSE(fs::exists(sweep.out("a")));
}

TEST(Sweep, SaysSoWhereNothingCanBeMeasured) {
  const ShortSweep sweep;
  const std::vector<Reading> no_scan{Reading{}};
  const World world = load_scenario(COGSLAM_SOURCE_DIR "/scenarios/simple.yaml").world;
  for (const std::string name : {"a", "b"}) {
    const SweepFolder folder{sweep.out(name)};
    folder.make();
    for (const PlannedEpisode& episode : load_sweep(sweep.root() / "sweep.yaml").episodes) {
      write_recording(folder.readings(episode.readings_key), {.readings = no_scan});
      write_truth_log(folder.truth(episode.readings_key),
                      {.readings_hash = readings_hash(no_scan), .world = world, .poses = {TruePose{}}});
    }
  }
  const Outcome nothing = run_program(sweep.words("a"));
  EXPECT_EQ(nothing.code, kNothingMeasured) << nothing.err;
  EXPECT_THAT(nothing.err, HasSubstr("og 0.2 m, room, seed 1: nothing measured: the readings hold no scan (see "));
  EXPECT_THAT(nothing.err, HasSubstr("16 of 16 episodes have no result"));
  const Outcome first = run_program(sweep.words("b", {"--fail-fast", "-j", "1"}));
  const std::string word = "nothing measured";
  EXPECT_NE(first.err.find(word), std::string::npos);
  EXPECT_EQ(first.err.find(word), first.err.rfind(word)) << "it stops at the first";
}

}  // namespace
}  // namespace cogslam
