#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>
#include <thread>

#include "cli/exit_codes.hpp"
#include "eval/sweep/database.hpp"
#include "tests/cli/running_program.hpp"
#include "tests/cli/sweep_files.hpp"

namespace cogslam {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Seconds = std::chrono::duration<double>;

/// Every row by its key, as text, costs included: what is there must never change.
std::map<std::string, std::string> rows_in(const fs::path& out) {
  std::map<std::string, std::string> rows;
  if (!fs::exists(out / "sweep.sqlite")) return rows;
  const EpisodeTable table = SweepDatabase(out / "sweep.sqlite").results();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::string text;
    for (const std::string& column : table.columns) {
      text += table.text(row, column) + "," + std::to_string(table.number(row, column).value_or(-1.0)) + ",";
    }
    EXPECT_TRUE(rows.emplace(table.text(row, "key"), text).second) << "a row stands there twice";
  }
  return rows;
}

int kills_wanted() {
  const char* wanted = std::getenv("COGSLAM_SWEEP_KILLS");
  return wanted == nullptr ? 6 : std::atoi(wanted);
}

TEST(SweepTrouble, KillsAtAnyMomentLoseAndDoubleNothing) {
  const ShortSweep sweep;
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program(sweep.words("whole", {"--quiet"})).code, kOk);
  const Seconds whole = std::chrono::steady_clock::now() - start;
  const std::string scores = content_of(sweep.out("whole") / "scores.csv");
  std::minstd_rand random(7);
  int kills = 0, sweeps = 0;
  for (const int wanted = kills_wanted(); kills < wanted || sweeps == 0; ++sweeps) {
    const std::string name = "killed" + std::to_string(sweeps);
    std::map<std::string, std::string> before;
    for (bool killed = true; killed;) {
      RunningProgram program(sweep.words(name, {"--quiet"}));
      if (kills < wanted) {
        std::this_thread::sleep_for(whole * std::uniform_real_distribution<>(0.0, 0.6)(random));
        program.send(SIGKILL);
      }
      const Outcome outcome = program.wait();
      killed = outcome.code == 128 + SIGKILL;
      kills += killed ? 1 : 0;
      ASSERT_TRUE(killed || outcome.code == kOk) << outcome.err;
      const auto after = rows_in(sweep.out(name));
      for (const auto& [key, row] : before) EXPECT_EQ(after.at(key), row) << "lost, or measured again";
      before = after;
    }
    EXPECT_EQ(before.size(), static_cast<std::size_t>(ShortSweep::kEpisodes));
    EXPECT_EQ(content_of(sweep.out(name) / "scores.csv"), scores);
    fs::remove_all(sweep.out(name));
  }
  std::cout << kills << " kills in " << sweeps << " sweeps\n";
}

TEST(SweepTrouble, GoesOnWithoutAWorkerThatDies) {
  const ShortSweep sweep;
  sweep.write_scenario(std::string(ShortSweep::kScenario) + "map: {margin_m: 20}\n");  // slower
  RunningProgram program(sweep.words("a"));
  const std::string children =
      "/proc/" + std::to_string(program.pid()) + "/task/" + std::to_string(program.pid()) + "/children";
  pid_t worker = 0;
  while (worker == 0 && !program.ended()) {
    std::ifstream(children) >> worker;
    // Only one that is past its start: dying there, it would take the first job along all the same.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  kill(worker, SIGKILL);
  const Outcome outcome = program.wait();
  if (outcome.err.find("signal 9") == std::string::npos && rows_in(sweep.out("a")).size() == 16) {
    return;  // it died while readings were made, and another made them
  }
  EXPECT_EQ(outcome.code, kRunFailed);
  EXPECT_THAT(outcome.err, HasSubstr(": the worker was ended by signal 9 (see "));
  EXPECT_THAT(outcome.err, HasSubstr("1 of 16 episodes have no result"));
  EXPECT_EQ(rows_in(sweep.out("a")).size(), 15U);
  EXPECT_EQ(run_program(sweep.words("a")).code, kOk);
  EXPECT_EQ(rows_in(sweep.out("a")).size(), 16U);
}

TEST(SweepTrouble, StopsWhereItIsInterrupted) {
  const ShortSweep sweep;
  const Outcome outcome = run_program(sweep.words("a"), {.interrupt_at = "[1/1]"});
  EXPECT_EQ(outcome.code, kInterrupted);
  EXPECT_THAT(outcome.err, HasSubstr("of 16 episodes are kept: run again to go on"));
  EXPECT_EQ(run_program(sweep.words("a")).code, kOk);
}

TEST(SweepTrouble, LetsOnlyOneSweepIntoAFolder) {
  const ShortSweep sweep;
  fs::create_directories(sweep.out("a"));
  const int lock = open((sweep.out("a") / "sweep.lock").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(flock(lock, LOCK_EX), 0);
  const Outcome second = run_program(sweep.words("a"));
  EXPECT_EQ(second.code, kUsageError);
  EXPECT_THAT(second.err, HasSubstr("another sweep is at work in this folder"));
  close(lock);
  EXPECT_EQ(run_program(sweep.words("a")).code, kOk);
}

TEST(SweepTrouble, MakesADamagedTableAnewFromTheFiles) {
  const ShortSweep sweep;
  ASSERT_EQ(run_program(sweep.words("a")).code, kOk);
  const std::string scores = content_of(sweep.out("a") / "scores.csv"),
                    costs = content_of(sweep.out("a") / "costs.csv");
  const fs::path database = sweep.out("a") / "sweep.sqlite";
  std::ofstream(database, std::ios::binary | std::ios::trunc) << std::string(10'000, 'x');
  const Outcome damaged = run_program(sweep.words("a"));
  EXPECT_EQ(damaged.code, kUsageError);
  EXPECT_THAT(damaged.err,
              HasSubstr("sweep.sqlite: file is not a database; where the file itself is at fault, move it"));
  fs::rename(database, sweep.out("a") / "damaged");
  const Outcome again = run_program(sweep.words("a"));
  EXPECT_THAT(again.err, HasSubstr("16 there, 0 to measure"));
  EXPECT_EQ(content_of(sweep.out("a") / "scores.csv"), scores);
  EXPECT_EQ(content_of(sweep.out("a") / "costs.csv"), costs);
}

TEST(SweepTrouble, NeedsAFolderThatCanBeWrittenTo) {
  const ShortSweep sweep;
  const Outcome outcome = run_program({"sweep", (sweep.root() / "sweep.yaml").string(), "--out", "/proc/sweep"});
  EXPECT_EQ(outcome.code, kUsageError);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/sweep/readings: cannot be made: "));
}

TEST(SweepTrouble, KeepsWhatItHasOnAFullDisk) {
  const ShortSweep sweep;
  fs::create_directories(sweep.out("a"));
  if (mount("none", sweep.out("a").c_str(), "tmpfs", 0, "size=1200k") != 0) {
    GTEST_SKIP() << "no small disk to fill, since none can be mounted: " << std::strerror(errno);
  }
  const Outcome full = run_program(sweep.words("a"));
  EXPECT_EQ(full.code, kRunFailed) << full.err;
  EXPECT_THAT(full.err, testing::ContainsRegex("No space left on device|disk is full|disk I/O error"));
  const auto before = rows_in(sweep.out("a"));
  EXPECT_EQ(mount("none", sweep.out("a").c_str(), "tmpfs", MS_REMOUNT, "size=50m"), 0);
  EXPECT_EQ(run_program(sweep.words("a")).code, kOk);
  const auto after = rows_in(sweep.out("a"));
  EXPECT_EQ(after.size(), 16U);
  for (const auto& [key, row] : before) EXPECT_EQ(after.at(key), row);
  umount(sweep.out("a").c_str());
}

}  // namespace
}  // namespace cogslam
