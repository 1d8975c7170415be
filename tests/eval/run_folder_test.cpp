#include "eval/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "eval/new_folder.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/short_scenario.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A drive of two seconds through a filter and a mapper.
struct ShortRun {
  Scenario scenario = short_scenario();
  Drive drive = record_drive(scenario);
  Workers workers{1};
  Episode episode = replay_variants(scenario.name, drive.recording, {.truth = &drive.truth}, scenario.variants,
                                    scenario.seed, workers);

  [[nodiscard]] RunFiles files() const {
    return {.episode = episode,
            .recording = drive.recording,
            .truth = &drive.truth,
            .config_name = "scenario.yaml",
            .config = scenario.resolved};
  }
};

TEST(RunFolder, HoldsEveryPartOfARun) {
  const TemporaryFolder parent;
  const ShortRun run;
  const fs::path folder = write_run_folder(parent.path() / "new" / "runs", run.files());
  EXPECT_THAT(folder.filename().string(), testing::MatchesRegex("short-[0-9a-f]{16}"));
  EXPECT_EQ(folder.parent_path(), parent.path() / "new" / "runs");
  std::set<std::string> expected{"scenario.yaml", "scores.json",   "truth.tum", "page.html",
                                 "odometry.tum",  "reference.tum", "room.png"};
  for (const std::string name : {"og_0.5m", "og_0.2m"}) {
    for (const char* end : {".pgm", ".yaml", ".npy", "_map.png", "_paths.png", "_online.tum", "_final.tum"}) {
      expected.insert(name + end);
    }
  }
  for (const std::string name : {"truth_og_0.5m", "truth_og_0.2m"}) {
    for (const char* end : {".pgm", ".yaml", ".npy", "_map.png"}) expected.insert(name + end);
  }
  EXPECT_EQ(names_in(folder), expected);
  EXPECT_EQ(content(folder / "scores.json"), to_json(run.episode.record));
  EXPECT_EQ(content(folder / "scenario.yaml"), run.scenario.resolved);
  EXPECT_EQ(content(folder / "room.png"), content(folder / "og_0.2m_paths.png")) << "the finest cell size";
}

TEST(RunFolder, SavesReadingsAndTruthOnRequest) {
  const TemporaryFolder parent;
  const ShortRun run;
  RunFiles files = run.files();
  files.save_readings = true;
  const fs::path folder = write_run_folder(parent.path(), files);
  EXPECT_EQ(readings_hash(read_recording(folder / "readings.bin").readings), *run.episode.record.readings_hash);
  EXPECT_EQ(read_truth_log(folder / "truth.bin").poses, run.drive.truth.poses);
}

TEST(RunFolder, IsNamedByWhatItHoldsButNotByCosts) {
  const TemporaryFolder parent;
  ShortRun run;
  const fs::path first = write_run_folder(parent.path(), run.files());
  run.episode.runs[0].record.costs.cpu_s = 1e9;
  EXPECT_EQ(write_run_folder(parent.path(), run.files()), first);
  RunFiles other = run.files();
  other.config += "# another\n";
  EXPECT_NE(write_run_folder(parent.path(), other), first);
  run.episode.runs[0].record.scores.path_mse_m2 = 1e9;
  EXPECT_NE(write_run_folder(parent.path(), run.files()), first);
}

TEST(RunFolder, LeavesNothingWhereItIsStopped) {
  const TemporaryFolder parent;
  const ShortRun run;
  struct Stop {};
  const StageBegin stop_half_way = [](const std::string&) {
    return Progress([](double done) {
      if (done > 0.4) throw Stop{};
    });
  };
  EXPECT_THROW(write_run_folder(parent.path(), run.files(), stop_half_way), Stop);
  EXPECT_EQ(names_in(parent.path()), std::set<std::string>{});
}

TEST(NewFolder, ReplacesAFolderThatIsThere) {
  const TemporaryFolder parent;
  for (const char* text : {"one", "two"}) {
    {
      NewFolder folder(parent.path() / "run");
      std::ofstream(folder.path() / text) << text;
      folder.move_to_target();
    }
    EXPECT_EQ(names_in(parent.path()), std::set<std::string>{"run"});
    EXPECT_EQ(names_in(parent.path() / "run"), std::set<std::string>{text});
  }
}

TEST(NewFolder, SaysWhyItCannotBeWritten) {
  const TemporaryFolder parent;
  const fs::path file = parent.file("file", "");
  EXPECT_EQ(error_text([&] { NewFolder(file / "run"); }), file.string() + ": cannot be written: Not a directory");
  NewFolder folder(file);
  EXPECT_EQ(error_text([&] { folder.move_to_target(); }), file.string() + ": cannot be written: Not a directory");
}

TEST(Episode, MeasuresNothingWithoutAScan) {
  Recording recording;
  recording.readings.resize(3);
  Workers workers(1);
  const Episode episode = replay_variants("empty", recording, {}, {VariantConfig{.name = "og"}}, 1, workers);
  EXPECT_TRUE(episode.record.variants.empty());
  EXPECT_EQ(episode.record.simulated_s, std::nullopt);
}

}  // namespace
}  // namespace cogslam
